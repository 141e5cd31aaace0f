package robotran.cli.files

import robotran.cli.CommandTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** All files are written by one function, which loses none; no other code of the JVM opens one for writing. */
class HandWrittenOutputsTest : CommandTest() {
    private val sources = listOf(
        "cli/src/main",
        "desktopApp/src/main",
        "shared/documents/src/jvmMain",
        "shared/workshop/src/jvmMain",
        "shared/ui/src/jvmMain",
        "shared/ui-common/src/jvmMain",
        "shared/ui-common/src/jvmAndAndroidMain",
        "shared/ui/src/jvmAndAndroidMain",
        "shared/desktop-tower/src/main",
    ).flatMap { folder -> tree.resolve(folder).walk().filter { it.extension == "kt" }.toList() }

    @Test
    fun `no other code opens a file for writing`() {
        assertTrue(sources.size > 100, "${sources.size} sources")
        val opened = sources.filter { it.name !in WRITERS }.flatMap { file ->
            OPENING.findAll(file.readText()).map { "${file.name}: ${it.value}" }
        }
        assertEquals(emptyList(), opened)
    }

    @Test
    fun `the search finds the ways in which a file can be opened`() {
        val ways = listOf(
            "path.writeText(text)",
            "Path.of(name).createParentDirectories().writeBytes(bytes)",
            "File(name).outputStream()",
            "FileOutputStream(name)",
            "Files.newBufferedWriter(path)",
            "Files.write(path, bytes)",
            "Files.copy(from, to)",
            "FileChannel.open(path)",
            "ImageIO.write(image, \"png\", file)",
            "from.copyTo(to, overwrite = true)",
        )
        assertEquals(emptyList(), ways.filterNot { OPENING.containsMatchIn(it) })
    }

    private companion object {
        /**
         * The writer itself, locks, the file of a tower, the drive of a micro:bit, which is no disk and takes no temporary
         * file, and marks of what is being opened: nobody sees those, they are made anew at each run, and waiting for the
         * disk would hold the window up.
         */
        val WRITERS = setOf(
            "SafeWriting.kt",
            "TemporaryFile.kt",
            "FolderKeyValueStore.kt",
            "DesktopMicrobitDrives.kt",
            "DeviceFileTower.kt",
            "FolderOpeningMarks.kt",
        )

        val OPENING = Regex(
            """\.(writeText|appendText|writeLines|appendLines|outputStream|bufferedWriter|printWriter|writer|""" +
                """appendBytes|copyTo|copyRecursively|moveTo)\(|(?<!port)\.writeBytes\(|""" +
                """\b(FileOutputStream|FileWriter|RandomAccessFile|PrintWriter)\(|\bFileChannel\.open|""" +
                """\bFiles\.(write|writeString|newOutputStream|newBufferedWriter|newByteChannel|copy|move|""" +
                """createTempFile|createFile)\(|\bImageIO\.write""",
        )
    }
}
