package robotran.android

import android.os.SystemClock
import android.view.InputDevice
import android.view.KeyEvent
import android.view.MotionEvent
import androidx.compose.ui.test.onNodeWithTag
import org.junit.Assert.assertNotEquals
import org.junit.Assert.assertNotNull
import org.junit.Assert.assertNull
import org.junit.Assert.assertTrue
import org.junit.Before
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import robotran.ui.world.tags.WorldTags
import robotran.workshop.state.DocumentDialog

/** A hardware keyboard and a mouse on the tablet. */
@RunWith(RobolectricTestRunner::class)
class KeyboardTest {
    @get:Rule
    val app = TestedApp()

    @Before
    fun open() {
        app.open(Device.TABLET_11_INCH.qualifiers(upright = false))
        app.leaveFirstPage()
    }

    @Test
    fun `F5 runs and Shift F5 stops`() {
        press(KeyEvent.KEYCODE_F5)
        app.pass(1_000)
        assertTrue(app.workshop.state.running)
        press(KeyEvent.KEYCODE_F5, KeyEvent.META_SHIFT_ON)
        app.pass(300)
        assertTrue(!app.workshop.state.running)
    }

    @Test
    fun `Ctrl Shift O shows all works`() {
        press(KeyEvent.KEYCODE_O, KeyEvent.META_CTRL_ON or KeyEvent.META_SHIFT_ON)
        app.settle()
        assertTrue(app.workshop.state.document.dialog is DocumentDialog.ProjectList)
    }

    @Test
    fun `Ctrl comma shows the settings and Escape leaves them`() {
        press(KeyEvent.KEYCODE_COMMA, KeyEvent.META_CTRL_ON)
        app.pass(300)
        assertTrue(app.workshop.state.settingsShown)
        press(KeyEvent.KEYCODE_ESCAPE)
        app.pass(300)
        assertTrue(!app.workshop.state.settingsShown)
    }

    @Test
    fun `keys that mean nothing are left to Android`() {
        assertNull(eventForKey(KeyEvent(KeyEvent.ACTION_DOWN, KeyEvent.KEYCODE_VOLUME_UP)))
        assertNotNull(eventForKey(KeyEvent(KeyEvent.ACTION_DOWN, KeyEvent.KEYCODE_F5)))
    }

    @Test
    fun `the wheel of a mouse zooms the sheet where it points`() {
        val before = app.workshop.state.sheet.camera
        val world = app.screen.onNodeWithTag(WorldTags.WORLD).fetchSemanticsNode().boundsInRoot.center
        app.activity.window.decorView.dispatchGenericMotionEvent(scroll(world.x, world.y))
        app.pass(500)
        assertNotEquals(before, app.workshop.state.sheet.camera)
    }

    private fun press(key: Int, meta: Int = 0) {
        val now = SystemClock.uptimeMillis()
        for (action in listOf(KeyEvent.ACTION_DOWN, KeyEvent.ACTION_UP)) {
            app.activity.dispatchKeyEvent(KeyEvent(now, now, action, key, 0, meta))
        }
        app.pass(100)
    }

    private fun scroll(x: Float, y: Float): MotionEvent {
        val now = SystemClock.uptimeMillis()
        val pointer = MotionEvent.PointerProperties().apply { toolType = MotionEvent.TOOL_TYPE_MOUSE }
        val place =
            MotionEvent.PointerCoords().apply {
                this.x = x
                this.y = y
                setAxisValue(MotionEvent.AXIS_VSCROLL, 2f)
            }
        return MotionEvent.obtain(
            now,
            now,
            MotionEvent.ACTION_SCROLL,
            1,
            arrayOf(pointer),
            arrayOf(place),
            0,
            0,
            1f,
            1f,
            0,
            0,
            InputDevice.SOURCE_MOUSE,
            0,
        )
    }
}
