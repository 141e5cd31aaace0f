package robotran.desktop.platform

import kotlinx.coroutines.Dispatchers
import robotran.ui.platform.Arrivals
import robotran.ui.platform.FileDesk
import robotran.ui.platform.JavaClock
import robotran.ui.platform.Platform
import robotran.ui.platform.Sharing
import robotran.ui.platform.WallClock
import robotran.ui.platform.WorkStore
import robotran.ui.sound.LoudSpeaker
import kotlin.coroutines.CoroutineContext

/** What this machine offers to one window. */
internal class DesktopPlatform(
    override val speaker: LoudSpeaker,
    override val store: WorkStore,
    override val files: FileDesk,
    override val arrivals: Arrivals,
    override val goesOn: Boolean,
) : Platform {
    override val sharing: Sharing = Clipboard
    override val clock: WallClock = JavaClock
    override val background: CoroutineContext = Dispatchers.Default
}
