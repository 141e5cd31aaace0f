@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.window

import androidx.compose.ui.InternalComposeUiApi
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.scene.ComposeScene
import kotlinx.browser.window
import org.w3c.dom.HTMLElement
import org.w3c.dom.events.Event
import org.w3c.dom.events.KeyboardEvent

/**
 * Passes keys to [scene]. Keys of input methods and clipboard shortcuts stay with the browser. Each key sees the
 * results of the previous ones, see [frames].
 */
@OptIn(InternalComposeUiApi::class)
internal class PageKeys(
    private val scene: ComposeScene,
    private val frames: SceneFrames,
    private val clipboard: PageClipboard,
) {
    /**
     * Gives keys that come up to the window to [take] if nothing below has taken them: those of a page in which nothing
     * has the focus, and those of the HTML beside the canvas. Only keys that write nothing are shortcuts.
     */
    fun listenToWindow(take: (KeyEvent) -> Boolean) = window.addEventListener("keydown", { event ->
        event as KeyboardEvent
        val isShortcut = event.ctrlKey || event.metaKey || event.key.length > 1
        if (isShortcut && !event.defaultPrevented && !event.isComposing && event.keyCode != AT_WORK) {
            if (take(pressed(event, KeyEventType.KeyDown))) event.preventDefault()
            frames.markPending()
        }
    })

    /** @param isWrittenInto whether [element] receives the typed text from the browser. */
    fun listenTo(element: HTMLElement, isWrittenInto: Boolean = false) {
        element.addEventListener("keydown") { take(it as KeyboardEvent, KeyEventType.KeyDown, isWrittenInto) }
        element.addEventListener("keyup") { take(it as KeyboardEvent, KeyEventType.KeyUp, isWrittenInto) }
        element.addEventListener("copy") { give(it, Key.C) }
        element.addEventListener("cut") { give(it, Key.X) }
        element.addEventListener("paste") {
            if (isWrittenInto) frames.catchUp() else paste(pastedInto(it))
        }
        element.addEventListener("input") { frames.markPending() }
    }

    private fun take(event: KeyboardEvent, type: KeyEventType, isWritten: Boolean) {
        if (type == KeyEventType.KeyDown && !event.isComposing) frames.catchUp()
        if (event.isComposing || event.keyCode == AT_WORK || event.key in UNFINISHED || isForClipboard(event)) return
        val isThirdLevel = event.getModifierState("AltGraph")
        if (isWritten && event.key.length == 1 && (isThirdLevel || writes(event))) return
        if (scene.sendKeyEvent(pressed(event, type))) event.preventDefault()
        frames.markPending()
    }

    private fun pressed(event: KeyboardEvent, type: KeyEventType): KeyEvent {
        val isThirdLevel = event.getModifierState("AltGraph")
        return KeyEvent(
            key = keyOf(event.key, event.code),
            type = type,
            codePoint = if (event.key.length == 1) event.key[0].code else 0,
            isCtrlPressed = event.ctrlKey && !isThirdLevel,
            isMetaPressed = event.metaKey,
            isAltPressed = event.altKey && !isThirdLevel,
            isShiftPressed = event.shiftKey,
            nativeEvent = event,
        )
    }

    /** Writes the selection to the clipboard of [event], like Ctrl and [key]. */
    private fun give(event: Event, key: Key) {
        frames.catchUp()
        val (text, isTaken) = clipboard.listen {
            scene.sendKeyEvent(KeyEvent(key, KeyEventType.KeyDown, isCtrlPressed = true, isMetaPressed = isApple()))
        }
        if (text != null) fill(event, text)
        if (isTaken) event.preventDefault()
        frames.markPending()
    }

    /** Lets what has the focus read [text], like Ctrl+V. */
    private fun paste(text: String) {
        frames.catchUp()
        clipboard.offer(text) {
            scene.sendKeyEvent(KeyEvent(Key.V, KeyEventType.KeyDown, isCtrlPressed = true, isMetaPressed = isApple()))
        }
        frames.markPending()
    }

    /** Whether a character with these modifiers is text input and not a shortcut. */
    private fun writes(event: KeyboardEvent) = !event.ctrlKey && !event.metaKey && (!event.altKey || isApple())

    private fun isForClipboard(event: KeyboardEvent): Boolean {
        val isHeld = (event.ctrlKey || event.metaKey) && !event.altKey
        return (isHeld && !event.shiftKey && event.key.lowercase() in CLIPBOARD) ||
            (event.key == "Insert" && isHeld != event.shiftKey) || (event.key == "Delete" && event.shiftKey && !isHeld)
    }

    private companion object {
        /** The key code that browsers report for keys handled by an input method. */
        const val AT_WORK = 229
        val UNFINISHED = setOf("Dead", "Process", "Unidentified")
        val CLIPBOARD = setOf("c", "x", "v")
    }
}

private fun fill(event: Event, text: String): Unit =
    js("{ event.clipboardData.setData('text/plain', text); event.preventDefault(); }")

private fun pastedInto(event: Event): String =
    js("{ event.preventDefault(); return event.clipboardData ? event.clipboardData.getData('text') : ''; }")

private fun isApple(): Boolean = js("/Mac|iPhone|iPad/.test(navigator.platform)")
