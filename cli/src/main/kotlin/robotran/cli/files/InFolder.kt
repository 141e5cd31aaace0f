package robotran.cli.files

import java.io.IOException
import java.nio.file.Path
import kotlin.io.path.isRegularFile
import kotlin.io.path.isSymbolicLink

/** Whether [path] names a place in [folder] or below it, before links are followed. */
internal fun isNamedIn(folder: Path, path: Path): Boolean =
    path.toAbsolutePath().normalize().startsWith(folder.toAbsolutePath().normalize())

/** Whether the file at [path] lies in [folder] or below it, wherever symbolic links lead. */
fun liesIn(folder: Path, path: Path): Boolean = try {
    path.toRealPath().startsWith(folder.toAbsolutePath().toRealPath())
} catch (_: IOException) {
    false
}

/** Whether [path] is a symbolic link to a file out of the folder in which it is. Devices and pipes are refused anyway. */
internal fun isLinkOutside(path: Path): Boolean =
    path.isSymbolicLink() && path.isRegularFile() && path.toAbsolutePath().parent?.let { liesIn(it, path) } == false
