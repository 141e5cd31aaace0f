package robotran.cli.files

import java.io.IOException
import java.nio.file.FileVisitResult
import java.nio.file.FileVisitor
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.BasicFileAttributes
import kotlin.io.path.isRegularFile

/**
 * The files in [folder] and its subfolders, at most [limit], sorted. Links to folders are not followed.
 *
 * @param withFolders whether the folders are among them, too.
 * @param fails is called with what cannot be read, such as somebody else's subfolder; all else is found nevertheless.
 */
fun filesIn(
    folder: Path,
    limit: Int,
    withFolders: Boolean = false,
    fails: (Path, IOException) -> Unit = { _, _ -> },
): List<Path> {
    val found = mutableListOf<Path>()
    Files.walkFileTree(
        folder,
        object : FileVisitor<Path> {
            override fun preVisitDirectory(path: Path, attributes: BasicFileAttributes): FileVisitResult {
                if (withFolders) found.add(path)
                return FileVisitResult.CONTINUE
            }

            override fun visitFile(path: Path, attributes: BasicFileAttributes): FileVisitResult {
                if (path.isRegularFile()) found.add(path)
                return if (found.size < limit) FileVisitResult.CONTINUE else FileVisitResult.TERMINATE
            }

            override fun visitFileFailed(path: Path, problem: IOException): FileVisitResult {
                fails(path, problem)
                return FileVisitResult.CONTINUE
            }

            override fun postVisitDirectory(path: Path, problem: IOException?): FileVisitResult {
                if (problem != null) fails(path, problem)
                return FileVisitResult.CONTINUE
            }
        },
    )
    return found.sorted()
}
