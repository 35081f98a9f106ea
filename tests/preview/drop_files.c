/* SPDX-FileCopyrightText: The libocean authors
 * SPDX-License-Identifier: Apache-2.0
 *
 * Drops files on a window as a file manager does, by the protocol XDND, version 5:
 *   drop_files TITLE PATH...
 * TITLE begins the title of the window. Ends with 0 when the window has taken the files. */
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static Display* display;

static Atom atom(const char* name) {
    return XInternAtom(display, name, False);
}

static Window find_window(Window in, const char* title) {
    Window root, parent, *children = NULL, found = None;
    unsigned count = 0;
    char* name = NULL;
    if (XFetchName(display, in, &name) && name) {
        if (strncmp(name, title, strlen(title)) == 0) found = in;
        XFree(name);
    }
    if (found != None || !XQueryTree(display, in, &root, &parent, &children, &count)) return found;
    for (unsigned i = 0; i < count && found == None; ++i) found = find_window(children[i], title);
    if (children) XFree(children);
    return found;
}

/* Returns "file:///a%20b" for each path, with lines ends as RFC 2483 has them. */
static char* uri_list(int count, char** paths) {
    size_t size = 1;
    for (int i = 0; i < count; ++i) size += 3 * strlen(paths[i]) + 16;
    char* list = malloc(size);
    char* end = list;
    for (int i = 0; i < count; ++i) {
        end += sprintf(end, "file://");
        for (const char* c = paths[i]; *c; ++c) {
            const unsigned char byte = (unsigned char)*c;
            const int plain = (byte >= '0' && byte <= '9') || (byte >= 'a' && byte <= 'z') ||
                              (byte >= 'A' && byte <= 'Z') || strchr("/._-", byte) != NULL;
            end += plain ? sprintf(end, "%c", byte) : sprintf(end, "%%%02X", byte);
        }
        end += sprintf(end, "\r\n");
    }
    return list;
}

static void send(Window to, const char* type, const long data[5]) {
    XEvent event;
    memset(&event, 0, sizeof event);
    event.xclient.type = ClientMessage;
    event.xclient.window = to;
    event.xclient.message_type = atom(type);
    event.xclient.format = 32;
    memcpy(event.xclient.data.l, data, 5 * sizeof *data);
    XSendEvent(display, to, False, NoEventMask, &event);
}

static void answer_request(const XSelectionRequestEvent* request, const char* list) {
    XEvent event;
    memset(&event, 0, sizeof event);
    event.xselection.type = SelectionNotify;
    event.xselection.requestor = request->requestor;
    event.xselection.selection = request->selection;
    event.xselection.target = request->target;
    event.xselection.property = request->property;
    event.xselection.time = request->time;
    XChangeProperty(display, request->requestor, request->property, request->target, 8,
                    PropModeReplace, (const unsigned char*)list, (int)strlen(list));
    XSendEvent(display, request->requestor, False, NoEventMask, &event);
}

int main(int argc, char** argv) {
    if (argc < 3 || !(display = XOpenDisplay(NULL))) return 2;
    const Window root = DefaultRootWindow(display);
    const Window target = find_window(root, argv[1]);
    if (target == None) {
        fprintf(stderr, "no window is called %s\n", argv[1]);
        return 2;
    }
    char* const list = uri_list(argc - 2, argv + 2);
    const Window source = XCreateSimpleWindow(display, root, 0, 0, 1, 1, 0, 0, 0);
    XSetSelectionOwner(display, atom("XdndSelection"), source, CurrentTime);
    const long from = (long)source;
    const long enter[5] = {from, 5L << 24, (long)atom("text/uri-list"), 0, 0};
    const long position[5] = {from, 0, 320L << 16 | 300, CurrentTime, (long)atom("XdndActionCopy")};
    const long drop[5] = {from, 0, CurrentTime, 0, 0};
    send(target, "XdndEnter", enter);
    send(target, "XdndPosition", position);
    for (;;) {
        XEvent event;
        XNextEvent(display, &event);
        if (event.type == SelectionRequest) answer_request(&event.xselectionrequest, list);
        if (event.type != ClientMessage) continue;
        if (event.xclient.message_type == atom("XdndStatus")) {
            if ((event.xclient.data.l[1] & 1) == 0) return 1; /* the window refuses */
            send(target, "XdndDrop", drop);
        }
        if (event.xclient.message_type == atom("XdndFinished")) break;
    }
    free(list);
    XCloseDisplay(display);
    return 0;
}
