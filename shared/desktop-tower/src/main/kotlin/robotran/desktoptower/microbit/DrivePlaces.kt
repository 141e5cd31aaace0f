package robotran.desktoptower.microbit

import java.io.IOException
import java.nio.file.FileSystems
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.isDirectory
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/** Where drives with the name of a board are on this machine. */
internal fun drivePlaces(): List<Path> =
    if (System.getProperty("os.name").startsWith("Windows")) windowsPlaces() else unixPlaces()

/** Linux shows drives in a folder of the user, or in `/media` and `/mnt` themselves; macOS in `/Volumes`. */
private fun unixPlaces(): List<Path> {
    val user = System.getProperty("user.name")
    return listOf("/media/$user", "/run/media/$user", "/media", "/mnt", "/Volumes").map(Path::of)
        .flatMap(::boardsIn).distinct()
}

private fun boardsIn(folder: Path): List<Path> = try {
    // A second board gets a number behind its name.
    folder.listDirectoryEntries().filter { it.name.startsWith(NAME) && it.isDirectory() }.sorted()
} catch (_: IOException) {
    emptyList()
}

private fun windowsPlaces(): List<Path> = FileSystems.getDefault().rootDirectories.filter { root ->
    try {
        Files.getFileStore(root).name().startsWith(NAME)
    } catch (_: IOException) {
        // A drive without a disk.
        false
    }
}

private const val NAME = "MICROBIT"
