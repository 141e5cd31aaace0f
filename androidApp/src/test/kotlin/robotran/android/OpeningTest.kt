package robotran.android

import android.content.Intent
import android.net.Uri
import android.os.Bundle
import kotlinx.coroutines.runBlocking
import org.junit.Assert.assertEquals
import org.junit.Assert.assertNull
import org.junit.Assert.assertTrue
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import org.robolectric.RuntimeEnvironment
import org.robolectric.Shadows.shadowOf
import robotran.language.Language
import robotran.projects.LinkCreation
import robotran.projects.Project
import robotran.projects.linkOf
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.Notice
import robotran.world.file.BuiltInWorlds
import java.io.ByteArrayInputStream
import java.io.IOException
import java.io.InputStream

/** Tests that the app opens content from other apps, and that no content crashes it. */
@RunWith(RobolectricTestRunner::class)
class OpeningTest {
    @get:Rule
    val app = TestedApp()

    private val uri: Uri = Uri.parse("content://files.example/document/wave.robo")

    @Test
    fun `a program that a file manager opens is in a tab`() {
        offer("pen down\nforward 3\n")
        app.open(intent = viewing(uri))
        app.settle()
        assertTrue(app.workshop.state.programs.programs.any { it.files.single().text == "pen down\nforward 3\n" })
    }

    @Test
    fun `a program comes while the app is open, too`() {
        app.open()
        offer("beep\n")
        app.receive(viewing(uri))
        assertTrue(app.workshop.state.programs.programs.any { it.files.single().text == "beep\n" })
    }

    @Test
    fun `what was opened once is not opened again from the list of apps`() {
        offer("beep\n")
        app.open(intent = viewing(uri).addFlags(Intent.FLAG_ACTIVITY_LAUNCHED_FROM_HISTORY))
        app.settle()
        assertTrue(app.workshop.state.programs.programs.none { it.files.single().text == "beep\n" })
    }

    @Test
    fun `what was opened once is not opened again when the process comes back`() {
        offer("beep\n")
        app.open(intent = viewing(uri), saved = Bundle())
        app.settle()
        assertTrue(app.workshop.state.programs.programs.none { it.files.single().text == "beep\n" })
    }

    @Test
    fun `a link that is sent opens its world`() {
        val maze = BuiltInWorlds.plain.copy(title = "Our maze")
        val link = runBlocking { linkOf(Project(maze), Language.ENGLISH) } as LinkCreation.Made
        app.open()
        app.receive(
            Intent(
                Intent.ACTION_SEND,
            ).putExtra(Intent.EXTRA_TEXT, "Try this: https://school.example/${link.fragment} today"),
        )
        assertEquals(maze.title, app.workshop.state.world.title)
    }

    @Test
    fun `a broken link is refused in words`() {
        app.open()
        app.receive(Intent(Intent.ACTION_VIEW, Uri.parse("robotran:#p=aBroken")))
        val dialog = app.workshop.state.document.dialog as DocumentDialog.PastingLink
        assertTrue(dialog.error.orEmpty().isNotEmpty())
        app.photograph("broken-link")
    }

    @Test
    fun `a file that breaks off is named in words`() = refusing {
        object : InputStream() {
            override fun read(): Int = throw IOException("gone")
        }
    }

    @Test
    fun `a file without an end is named in words`() = refusing {
        object : InputStream() {
            override fun read(): Int = 'x'.code

            override fun read(bytes: ByteArray): Int = bytes.size
        }
    }

    @Test
    fun `a provider that throws its own mistakes is named in words`() = refusing {
        object : InputStream() {
            override fun read(): Int = throw IllegalStateException("a mistake of somebody else's")
        }
    }

    @Test
    fun `a file of another kind is refused in a dialog`() {
        val letter = Uri.parse("content://files.example/document/letter.pdf")
        offer("%PDF-1.4", letter)
        app.open()
        app.receive(viewing(letter))
        assertTrue(app.workshop.state.document.dialog is DocumentDialog.Rejected)
    }

    private fun refusing(stream: () -> InputStream) {
        shadowOf(RuntimeEnvironment.getApplication().contentResolver).registerInputStreamSupplier(uri, stream)
        app.open()
        app.receive(viewing(uri))
        assertNull(app.workshop.state.document.dialog)
        val notice = app.workshop.state.notice as Notice.ExternalError
        assertTrue(notice.sentence, "wave.robo cannot be read" in notice.sentence)
    }

    private fun offer(text: String, at: Uri = uri) {
        val resolver = shadowOf(RuntimeEnvironment.getApplication().contentResolver)
        resolver.registerInputStreamSupplier(at) { ByteArrayInputStream(text.toByteArray()) }
    }

    private fun viewing(uri: Uri) = Intent(Intent.ACTION_VIEW).setDataAndType(uri, "application/octet-stream")
}
