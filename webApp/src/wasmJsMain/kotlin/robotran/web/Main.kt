package robotran.web

import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.window.ComposeViewport
import kotlinx.browser.document
import robotran.ui.RobotranStart
import robotran.ui.platform.MemoryPlatform

/** Puts the workshop into the page, in place of the words that are shown while it loads. */
@OptIn(ExperimentalComposeUiApi::class)
fun main() {
    val page = checkNotNull(document.body) { "The page has no body." }
    document.getElementById("loading")?.remove()
    val platform = MemoryPlatform(WebSpeaker())
    ComposeViewport(page) { RobotranStart(platform = platform, onOpened = ::openPageInterface) }
}
