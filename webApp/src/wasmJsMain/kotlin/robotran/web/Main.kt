package robotran.web

import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.window.ComposeViewport
import kotlinx.browser.document
import robotran.ui.RobotranStart

/** Puts the workshop into the page, in place of the words that are shown while it loads. */
@OptIn(ExperimentalComposeUiApi::class)
fun main() {
    val page = checkNotNull(document.body) { "The page has no body." }
    document.getElementById("loading")?.remove()
    val speaker = WebSpeaker()
    ComposeViewport(page) { RobotranStart(speaker = speaker, onOpened = ::openPageInterface) }
}
