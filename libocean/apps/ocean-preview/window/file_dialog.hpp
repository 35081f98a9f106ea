// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The desktop's dialog for files: a program beside the window, so that the sea is drawn on while a
// user chooses.
#pragma once

#include <optional>
#include <string>

namespace ocean::app {

enum class FilePurpose { open, save };

class FileDialog {
  public:
    struct Answer {
        FilePurpose purpose;
        std::string path;  // "" if the user cancelled
    };

    FileDialog() = default;
    /// Ends an open dialog.
    ~FileDialog();
    FileDialog(const FileDialog&) = delete;
    FileDialog& operator=(const FileDialog&) = delete;

    /// Returns the programs that can ask for a file.
    static const char* programs() { return "zenity, kdialog, qarma or yad"; }
    /// Returns true if one of them is installed.
    static bool is_available();

    bool is_open() const { return child_ > 0; }
    /// Opens the dialog; does nothing while one is open. suggested: a folder ending in a slash, or
    /// the name of a file. A dialog that saves asks before it replaces a file. Throws Error.
    void ask(FilePurpose purpose, const std::string& suggested);
    /// Returns the answer once there is one; never blocks. Throws Error unsupported if the program
    /// failed.
    std::optional<Answer> poll();

  private:
    void read_answer();

    int child_ = 0;    // its process; 0 while no dialog is open
    int output_ = -1;  // of the child, as it is read here
    FilePurpose purpose_ = FilePurpose::open;
    std::string program_;
    std::string answer_;
};

}  // namespace ocean::app
