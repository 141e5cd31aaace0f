package robotran.cli.console

import robotran.console.ExitCode
import robotran.simulation.picture.WorldPictures

/** What the desktop app adds to the command line. Implementations should load UI classes only on use. */
interface DesktopApp {
    val pictures: WorldPictures

    /** Opens the window with [files] and returns once it is closed. */
    fun openWindow(files: List<String>): ExitCode
}
