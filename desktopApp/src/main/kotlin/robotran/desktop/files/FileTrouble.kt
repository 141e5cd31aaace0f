package robotran.desktop.files

import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.AccessDeniedException
import java.nio.file.InvalidPathException
import java.nio.file.NoSuchFileException
import java.util.zip.ZipException

/** What [work] makes of the file [name], or what [refuse] makes of a sentence about why it cannot be read. */
internal fun <T> reading(
    name: String,
    refuse: (String) -> T,
    work: () -> T,
): T =
    try {
        work()
    } catch (_: NoSuchFileException) {
        refuse("There is no file $name.")
    } catch (_: InvalidPathException) {
        refuse("There is no file $name.")
    } catch (_: AccessDeniedException) {
        refuse("$name could not be read: that is not allowed.")
    } catch (_: CharacterCodingException) {
        refuse("$name is not a text in UTF-8.")
    } catch (_: ZipException) {
        refuse("$name is no jar, or a damaged one.")
    } catch (problem: IOException) {
        refuse("$name could not be read: ${problem.message}")
    }
