@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web

import org.jetbrains.compose.resources.ExperimentalResourceApi
import org.jetbrains.compose.resources.configureWebResources

/**
 * Fonts and texts lie under names that say what is in them; the script of the page, `src/site/start.js`, knows which.
 */
@OptIn(ExperimentalResourceApi::class)
internal fun findResourcesInSite() = configureWebResources { resourcePathMapping(::addressOf) }

private fun addressOf(path: String): String = js("globalThis.robotranPage.addressOf(path)")

/** Takes the words away that are shown while the app loads, and lets the page be kept for days without a network. */
internal fun sayThatAppIsThere(): Unit = js("globalThis.robotranPage.started()")
