package robotran.nxt

import robotran.brick.controls.BrickButton
import robotran.language.Language
import robotran.nxt.messages.NxtMessages
import robotran.nxt.state.MenuView
import robotran.nxt.storage.NxtFile
import kotlin.test.Test
import kotlin.test.assertEquals

/** What programs have written is in the menu of the brick, which can delete it. */
class FilesInMenuTest {
    private val files = listOf(NxtFile("log.txt", ByteArray(1234)), NxtFile("a name of many letters", ByteArray(5)))
    private val brick =
        NxtBrick(listOf(scriptedProgram("endless")), files = files, messages = NxtMessages.of(Language.ENGLISH))

    private fun push(vararg buttons: BrickButton): MenuView? {
        for (button in buttons) {
            brick.press(button)
            brick.release(button)
            repeat(3) { brick.tick() }
        }
        return brick.state.menu
    }

    private val openFiles = arrayOf(BrickButton.RIGHT, BrickButton.ENTER)

    @Test
    fun `files are behind the programs with their sizes`() {
        val menu = push(*openFiles)
        assertEquals(listOf("endless", "log.txt    1234", "a name of man 5"), menu?.entries)
        assertEquals(files, brick.state.files)
    }

    @Test
    fun `a file can be deleted after a question`() {
        push(*openFiles)
        val file = push(BrickButton.RIGHT, BrickButton.ENTER)
        assertEquals(MenuView("log.txt", listOf("1234 bytes", "Delete file"), 0), file)
        val question = push(BrickButton.RIGHT, BrickButton.ENTER)
        assertEquals(MenuView("Delete?", listOf("No", "Yes"), 0), question)
        assertEquals(" Delete?     8.0", brick.state.display.lines[0], "the whole question beside the volts")
        assertEquals("log.txt", push(BrickButton.ENTER)?.title)
        assertEquals(files, brick.state.files)
        val after = push(BrickButton.ENTER, BrickButton.RIGHT, BrickButton.ENTER)
        assertEquals("Files" to listOf("endless", "a name of man 5"), after?.title to after?.entries)
        assertEquals(files.drop(1), brick.state.files)
    }

    @Test
    fun `all files can be deleted together`() {
        push(*Array(4) { BrickButton.RIGHT }, BrickButton.ENTER)
        val system = push(BrickButton.LEFT, BrickButton.ENTER)
        assertEquals("Format", system?.title)
        val after = push(BrickButton.RIGHT, BrickButton.ENTER)
        assertEquals("System" to "Flash: 130304", after?.title to after?.entries?.get(2))
        assertEquals(emptyList(), brick.state.files)
    }

    @Test
    fun `an empty brick says so`() {
        val empty = NxtBrick(emptyList(), messages = NxtMessages.of(Language.ENGLISH))
        openFiles.forEach {
            empty.press(it)
            empty.release(it)
            empty.tick()
        }
        assertEquals(listOf("(no files)"), empty.state.menu?.entries)
    }
}
