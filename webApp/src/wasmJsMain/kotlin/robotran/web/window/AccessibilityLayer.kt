@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.window

import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.text.AnnotatedString
import kotlinx.browser.document
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLInputElement
import org.w3c.dom.HTMLTextAreaElement

/** The elements for one layer of the screen, such as a dialog. Each element lives as long as its semantics node. */
internal class AccessibilityLayer(root: HTMLElement) {
    private val layer = document.createElement("div") as HTMLElement
    private val shown = HashMap<String, AccessibilityElement>()

    init {
        root.appendChild(layer)
    }

    fun show(all: List<AccessibilityNode>) {
        val gone = shown.keys - all.mapTo(HashSet()) { it.id }
        for (id in gone) shown.remove(id)?.element?.remove()
        var place = layer.firstElementChild
        for (described in all) {
            val before = shown[described.id]
            if (before != null && before.described.tag != described.tag) {
                if (place == before.element) place = place.nextElementSibling
                before.element.remove()
                shown.remove(described.id)
            }
            val now = shown.getOrPut(described.id) { AccessibilityElement(described) }
            now.show(described)
            if (place == now.element) place = place.nextElementSibling else layer.insertBefore(now.element, place)
        }
    }

    fun remove() = layer.remove()
}

/** One element, which forwards actions to its semantics node. */
private class AccessibilityElement(first: AccessibilityNode) {
    val element = document.createElement(first.tag) as HTMLElement

    var described = first
        private set
    private var isNew = true

    init {
        element.id = first.id
        for ((name, value) in STYLE) element.style.setProperty(name, value)
        when (first.tag) {
            "button" -> element.addEventListener("click") { press() }
            "input" -> element.addEventListener("input") { slide() }

            "textarea" -> {
                element.addEventListener("focus") { enter() }
                element.addEventListener("input") { write() }
            }
        }
    }

    fun show(now: AccessibilityNode) {
        val before = described
        described = now
        if (isNew || now.attributes != before.attributes) {
            if (!isNew) for (name in before.attributes.keys - now.attributes.keys) element.removeAttribute(name)
            for ((name, value) in now.attributes) {
                if (element.getAttribute(name) != value) {
                    element.setAttribute(name, value)
                }
            }
        }
        if (isNew || now.place != before.place) {
            SIDES.forEachIndexed { number, name -> element.style.setProperty(name, now.place[number]) }
        }
        if (isNew || now.text != before.text) showText(now.text)
        isNew = false
    }

    private fun showText(text: String) {
        when (described.tag) {
            "textarea" -> (element as HTMLTextAreaElement).let { if (it.value != text) it.value = text }
            "input" -> (element as HTMLInputElement).let { if (it.value != text) it.value = text }
            else -> element.textContent = text
        }
    }

    private fun press() {
        val action = described.action
        if (action != null) {
            action.action()
        } else {
            described.node.config.getOrNull(SemanticsActions.OnClick)?.action?.invoke()
        }
    }

    private fun slide() {
        val value = (element as HTMLInputElement).value.toFloatOrNull() ?: return
        described.node.config.getOrNull(SemanticsActions.SetProgress)?.action?.invoke(value)
    }

    /** Text input continues in the hidden browser field for Compose. */
    private fun enter() {
        val config = described.node.config
        (
            config.getOrNull(SemanticsActions.RequestFocus) ?: config.getOrNull(SemanticsActions.OnClick)
        )?.action?.invoke()
    }

    private fun write() {
        val text = AnnotatedString((element as HTMLTextAreaElement).value)
        described.node.config.getOrNull(SemanticsActions.SetText)?.action?.invoke(text)
    }

    private companion object {
        val SIDES = listOf("left", "top", "width", "height")

        /** Positioned at its bounds, independent of the page's button styles. */
        val STYLE = mapOf(
            "position" to "absolute",
            "box-sizing" to "border-box",
            "min-width" to "0",
            "min-height" to "0",
            "margin" to "0",
            "padding" to "0",
            "border" to "none",
            "overflow" to "hidden",
        )
    }
}
