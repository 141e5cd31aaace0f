package robotran.cli.files

import robotran.cli.messages.FileMessages
import java.io.IOException
import java.io.UncheckedIOException
import java.nio.file.AccessDeniedException
import java.nio.file.DirectoryIteratorException
import java.nio.file.InvalidPathException
import java.nio.file.NoSuchFileException
import java.util.zip.ZipException

/** Returns the result of [work], or of [refuse] with an error message if the file [name] cannot be read. */
internal fun <T> reading(name: String, messages: FileMessages, refuse: (String) -> T, work: () -> T): T = try {
    work()
} catch (_: NoSuchFileException) {
    refuse(messages.noFile(name))
} catch (_: InvalidPathException) {
    refuse(messages.noFile(name))
} catch (_: AccessDeniedException) {
    refuse(messages.notAllowed(name))
} catch (_: ZipException) {
    refuse(messages.notAJar(name))
} catch (problem: IOException) {
    refuse(messages.unreadable(name, problem.message.orEmpty()))
} catch (problem: UncheckedIOException) {
    reading(name, messages, refuse) { throw checkNotNull(problem.cause) }
} catch (problem: DirectoryIteratorException) {
    reading(name, messages, refuse) { throw checkNotNull(problem.cause) }
}
