package robotran.android.platform

import android.content.ContentResolver
import android.provider.Settings
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue

/** Whether animations are switched off in the settings of the device: "Remove animations" sets their duration to 0. */
class AndroidMotion(private val resolver: ContentResolver) {
    var isReduced: Boolean by mutableStateOf(false)
        private set

    init {
        look()
    }

    /** Must be called when the app comes back, since the user may have been in the settings. */
    fun look() {
        isReduced = Settings.Global.getFloat(resolver, Settings.Global.ANIMATOR_DURATION_SCALE, 1f) == 0f
    }
}
