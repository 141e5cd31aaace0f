package robotran.android

import android.provider.Settings
import org.junit.Assert.assertFalse
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import org.robolectric.RuntimeEnvironment

@RunWith(RobolectricTestRunner::class)
class MotionTest {
    private val context = RuntimeEnvironment.getApplication()

    @Test
    fun `whoever removes animations in the settings of the device has less motion, also from then on`() {
        val platform = AndroidPlatform(context)
        assertFalse(platform.prefersLessMotion)
        Settings.Global.putFloat(context.contentResolver, Settings.Global.ANIMATOR_DURATION_SCALE, 0f)
        platform.motion.look()
        assertTrue(platform.prefersLessMotion)
        assertTrue(AndroidPlatform(context).prefersLessMotion)
    }
}
