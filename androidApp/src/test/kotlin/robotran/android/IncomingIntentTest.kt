package robotran.android

import android.content.Intent
import android.content.pm.PackageManager
import android.net.Uri
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import org.robolectric.RuntimeEnvironment

@RunWith(RobolectricTestRunner::class)
class IncomingIntentTest {
    private val file: Uri = Uri.parse("content://files.example/document/primary%3ADownload%2Fmaze.world.json")

    @Test
    fun `a file is handed over by a file manager, a mail or another app's share sheet`() {
        assertEquals(
            IncomingIntent(listOf(file)),
            parseIntent(Intent(Intent.ACTION_VIEW).setDataAndType(file, "application/json")),
        )
        assertEquals(
            IncomingIntent(listOf(file)),
            parseIntent(Intent(Intent.ACTION_SEND).putExtra(Intent.EXTRA_STREAM, file)),
        )
        val several = Intent(
            Intent.ACTION_SEND_MULTIPLE,
        ).putParcelableArrayListExtra(Intent.EXTRA_STREAM, arrayListOf(file, file))
        assertEquals(IncomingIntent(listOf(file, file)), parseIntent(several))
    }

    @Test
    fun `a link is found among the words of a message`() {
        val words = "Look what I made:\nhttps://school.example/robotran/#p=aXY_- See you"
        val message = Intent(Intent.ACTION_SEND).putExtra(Intent.EXTRA_TEXT, words)
        assertEquals(IncomingIntent(link = "https://school.example/robotran/#p=aXY_-"), parseIntent(message))
    }

    @Test
    fun `a link that is touched is taken whole`() {
        for (link in listOf("robotran:#w=aXY", "https://school.example/robotran/#p=aXY")) {
            assertEquals(IncomingIntent(link = link), parseIntent(Intent(Intent.ACTION_VIEW, Uri.parse(link))))
        }
    }

    @Test
    fun `a text that is no link is handed on to be refused in words`() {
        val intent = Intent(Intent.ACTION_SEND).putExtra(Intent.EXTRA_TEXT, "good morning")
        assertEquals(IncomingIntent(link = "good morning"), parseIntent(intent))
    }

    @Test
    fun `a path of the app's own files is not taken from anybody`() {
        val own = Uri.parse("file:///data/data/org.robotran.app/files/work/work-1.text")
        assertEquals(IncomingIntent(), parseIntent(Intent(Intent.ACTION_VIEW, own)))
        assertEquals(IncomingIntent(), parseIntent(Intent(Intent.ACTION_SEND).putExtra(Intent.EXTRA_STREAM, own)))
    }

    @Test
    fun `an intent with nothing in it hands over nothing`() {
        for (action in listOf(
            Intent.ACTION_MAIN,
            Intent.ACTION_VIEW,
            Intent.ACTION_SEND,
            Intent.ACTION_SEND_MULTIPLE,
            null,
        )) {
            assertEquals(IncomingIntent(), parseIntent(Intent(action)))
        }
    }

    @Test
    fun `Android offers the app for our files, whatever type they are given`() {
        for (type in listOf("application/json", "application/octet-stream", "text/plain", "application/x-robotran")) {
            assertTrue(
                type,
                isOffered(Intent(Intent.ACTION_VIEW).setDataAndType(Uri.parse("content://files.example/17"), type)),
            )
            assertTrue(type, isOffered(Intent(Intent.ACTION_SEND).setType(type)))
        }
        for (name in listOf("maze.robotran", "my.first.robo", "a.b.world.json", "my.sumo.robot.json")) {
            val place = Uri.parse("content://files.example/document/$name")
            assertTrue(name, isOffered(Intent(Intent.ACTION_VIEW).setDataAndType(place, "application/x-who-knows")))
        }
    }

    @Test
    fun `Android offers the app for its own links and no other pages`() {
        assertTrue(isOffered(browsing("robotran:#p=aXY")))
        assertFalse(isOffered(browsing("https://school.example/")))
    }

    @Test
    fun `Android does not offer the app for pictures`() {
        val picture = Intent(
            Intent.ACTION_VIEW,
        ).setDataAndType(Uri.parse("content://files.example/17.png"), "image/png")
        assertFalse(isOffered(picture))
    }

    private fun browsing(address: String) =
        Intent(Intent.ACTION_VIEW, Uri.parse(address)).addCategory(Intent.CATEGORY_BROWSABLE)

    private fun isOffered(intent: Intent): Boolean {
        val app = RuntimeEnvironment.getApplication()
        val asked = intent.addCategory(Intent.CATEGORY_DEFAULT)
        val offered = app.packageManager.queryIntentActivities(asked, PackageManager.MATCH_DEFAULT_ONLY)
        return offered.any { it.activityInfo.name == MainActivity::class.java.name }
    }
}
