package robotran.android

import android.app.Activity
import android.content.ComponentName
import android.content.Intent
import android.content.IntentFilter
import android.graphics.Bitmap
import android.graphics.Color
import android.net.Uri
import android.provider.MediaStore
import kotlinx.coroutines.runBlocking
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertTrue
import org.junit.Before
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import org.robolectric.RuntimeEnvironment
import org.robolectric.Shadows.shadowOf
import org.robolectric.shadows.ShadowActivity
import robotran.language.Language
import robotran.projects.LinkCreation
import robotran.projects.Project
import robotran.projects.linkOf
import robotran.qrcode.QrCode
import robotran.ui.school.tags.HandInTags
import robotran.workshop.event.HandInsEvent
import robotran.workshop.platform.QrScannerWords
import robotran.workshop.state.HandInsMessage
import robotran.workshop.state.HandInsState
import robotran.workshop.state.QrScannerKind
import robotran.world.file.BuiltInWorlds
import java.io.File

/** Tests that a teacher takes pictures of QR codes with the camera app. */
@RunWith(RobolectricTestRunner::class)
class PhotosTest {
    @get:Rule
    val app = TestedApp()

    private val context = RuntimeEnvironment.getApplication()
    private val page: HandInsState get() = checkNotNull(app.workshop.state.handIns)

    @Before
    fun forgetPlaces() = forgetProvidedFiles()

    @Test
    fun `without a camera app only pictures are offered`() {
        openHandIns()
        assertEquals(listOf(QrScannerKind.PICTURES), page.scanners)
        assertFalse(app.isThere(HandInTags.HAND_INS_SCAN))
        assertTrue(app.isThere(HandInTags.HAND_INS_SCAN_PICTURES))
    }

    @Test
    fun `a code in a picture that is taken becomes a hand-in, and the picture is gone`() {
        installCamera()
        openHandIns()
        assertTrue(app.isThere(HandInTags.HAND_INS_SCAN))
        assertTrue(app.isThere(HandInTags.HAND_INS_SCAN_PICTURES))
        val link = runBlocking { linkOf(Project(BuiltInWorlds.plain), Language.ENGLISH) } as LinkCreation.Made
        answer(Activity.RESULT_OK) {
            write(it, pictureOf(checkNotNull(QrCode.of("https://a.example/${link.fragment}"))))
        }
        app.waitUntil("There is no hand-in") { page.rows.isNotEmpty() }
        assertEquals(listOf("Pasted link 1"), page.rows.map { it.submission.origin })
        assertFalse(File(context.cacheDir, "photos").exists())
        assertFalse(page.isScanning)
    }

    @Test
    fun `a picture without a code is told, and one that is not taken is not`() {
        installCamera()
        openHandIns()
        answer(Activity.RESULT_CANCELED) { }
        assertEquals(null, page.message)
        answer(Activity.RESULT_OK) { write(it, Bitmap.createBitmap(200, 200, Bitmap.Config.ARGB_8888)) }
        app.waitUntil("Nothing is told") { page.message != null }
        assertEquals(HandInsMessage.NoCodes(isPhoto = true), page.message)
        app.photograph("no-code-in-photo")
    }

    @Test
    fun `a camera app that does not open is told`() {
        installCamera()
        openHandIns()
        shadowOf(context).checkActivities(true)
        shadowOf(context.packageManager).removeActivity(CAMERA)
        requestPhoto()
        assertEquals(HandInsMessage.NoCamera, page.message)
    }

    private fun openHandIns() {
        app.open("w411dp-h891dp-port")
        app.workshop.handle(HandInsEvent.Requested)
        app.settle()
    }

    private fun requestPhoto() {
        val words = QrScannerWords("", "", "", "", "", "")
        app.workshop.handle(HandInsEvent.ScanRequested(QrScannerKind.PHOTO, words))
        app.settle()
    }

    /** Takes a picture: the camera app does [work] with the place for it. */
    private fun answer(result: Int, work: (Uri) -> Unit) {
        requestPhoto()
        val asked: ShadowActivity.IntentForResult = shadowOf(app.activity).nextStartedActivityForResult
        assertEquals(MediaStore.ACTION_IMAGE_CAPTURE, asked.intent.action)
        @Suppress("DEPRECATION")
        work(checkNotNull(asked.intent.getParcelableExtra(MediaStore.EXTRA_OUTPUT)))
        shadowOf(app.activity).receiveResult(asked.intent, result, null)
        app.settle()
        app.waitUntil("The picture is not looked at") { !page.isScanning }
    }

    private fun write(uri: Uri, picture: Bitmap) {
        assertEquals("${context.packageName}.photos", uri.authority)
        checkNotNull(context.contentResolver.openOutputStream(uri)).use {
            picture.compress(Bitmap.CompressFormat.JPEG, 90, it)
        }
    }

    private fun pictureOf(code: QrCode): Bitmap {
        val side = (code.size + 2 * QUIET) * MODULE
        val picture = Bitmap.createBitmap(side, side, Bitmap.Config.ARGB_8888)
        for (y in 0 until side) {
            for (x in 0 until side) {
                val (column, row) = x / MODULE - QUIET to y / MODULE - QUIET
                val isDark = column in 0 until code.size && row in 0 until code.size && code.isDark(column, row)
                picture.setPixel(x, y, if (isDark) Color.BLACK else Color.WHITE)
            }
        }
        return picture
    }

    private fun installCamera() {
        val packages = shadowOf(context.packageManager)
        packages.addActivityIfNotPresent(CAMERA)
        val filter = IntentFilter(MediaStore.ACTION_IMAGE_CAPTURE).apply { addCategory(Intent.CATEGORY_DEFAULT) }
        packages.addIntentFilterForActivity(CAMERA, filter)
    }

    private companion object {
        val CAMERA = ComponentName("camera.example", "camera.example.Camera")
        const val MODULE = 6

        /** Modules around the code. */
        const val QUIET = 4
    }
}
