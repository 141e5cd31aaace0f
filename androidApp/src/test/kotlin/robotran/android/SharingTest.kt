package robotran.android

import android.content.ClipboardManager
import android.content.Intent
import kotlinx.coroutines.runBlocking
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Before
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import org.robolectric.RuntimeEnvironment
import org.robolectric.Shadows.shadowOf
import robotran.documents.FileKind

@RunWith(RobolectricTestRunner::class)
class SharingTest {
    private val context = RuntimeEnvironment.getApplication()
    private val sharing = AndroidPlatform(context).sharing

    @Before
    fun forgetPlaces() = forgetProvidedFiles()

    @Test
    fun `a link goes to the share sheet as text`() = runBlocking {
        assertTrue(sharing.share("#p=aXY"))
        val chooser = shadowOf(context).nextStartedActivity
        assertEquals(Intent.ACTION_CHOOSER, chooser.action)
        @Suppress("DEPRECATION")
        val message = checkNotNull(chooser.getParcelableExtra<Intent>(Intent.EXTRA_INTENT))
        assertEquals("text/plain", message.type)
        assertEquals("#p=aXY", message.getStringExtra(Intent.EXTRA_TEXT))
    }

    @Test
    fun `a picture goes to the share sheet as a file that the other app may read`() = runBlocking {
        assertTrue(sharing.canShareFiles)
        assertTrue(sharing.shareFile("square.png", FileKind.PNG, byteArrayOf(1, 2, 3)))
        val chooser = shadowOf(context).nextStartedActivity

        @Suppress("DEPRECATION")
        val message = checkNotNull(chooser.getParcelableExtra<Intent>(Intent.EXTRA_INTENT))
        assertEquals("image/png", message.type)
        assertTrue(message.flags and Intent.FLAG_GRANT_READ_URI_PERMISSION != 0)
    }

    @Test
    fun `a link is copied`() = runBlocking {
        assertTrue(sharing.copy("#p=aXY"))
        val clip = context.getSystemService(ClipboardManager::class.java)?.primaryClip
        assertEquals("#p=aXY", clip?.getItemAt(0)?.text.toString())
    }
}
