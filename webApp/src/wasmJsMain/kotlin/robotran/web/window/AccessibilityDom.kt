@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.window

import androidx.compose.ui.InternalComposeUiApi
import androidx.compose.ui.platform.PlatformContext
import androidx.compose.ui.semantics.SemanticsOwner
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.semantics.getOrNull
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.HTMLCanvasElement
import org.w3c.dom.HTMLElement

/**
 * Compose's semantics as invisible HTML above the canvas, for screen readers: buttons, texts, fields, and live regions.
 * It does not intercept touches. The Tab key stays with the canvas, which reports the focused element.
 *
 * @param tellOpen receives the number of open dialogs and menus.
 */
@OptIn(InternalComposeUiApi::class)
internal class AccessibilityDom(
    place: HTMLElement,
    private val canvas: HTMLCanvasElement,
    private val input: PageTextInput,
    private val fonts: PageFonts,
    private val density: () -> Float,
    private val tellOpen: (Int) -> Unit,
) : PlatformContext.SemanticsOwnerListener {
    private val root = document.createElement("div") as HTMLElement
    private val layers = LinkedHashMap<SemanticsOwner, AccessibilityLayer>()
    private var isDue = false
    private var focused = ""

    init {
        root.id = "robotran-words"
        for ((name, value) in STYLE) root.style.setProperty(name, value)
        place.appendChild(root)
        canvas.setAttribute("role", "application")
        canvas.setAttribute("aria-label", "Robotran")
        canvas.setAttribute("aria-owns", root.id)
    }

    override fun onSemanticsOwnerAppended(semanticsOwner: SemanticsOwner) {
        layers[semanticsOwner] = AccessibilityLayer(root)
        changed()
    }

    override fun onSemanticsOwnerRemoved(semanticsOwner: SemanticsOwner) {
        layers.remove(semanticsOwner)?.remove()
        changed()
    }

    override fun onSemanticsChange(semanticsOwner: SemanticsOwner) = changed()

    override fun onLayoutChange(semanticsOwner: SemanticsOwner, semanticsNodeId: Int) = changed()

    private fun changed() {
        if (isDue) return
        isDue = true
        window.setTimeout({
            isDue = false
            show()
            null
        }, PAUSE)
    }

    /** Dialogs and menus are modal: elements below them are not reachable. */
    private fun show() {
        root.style.left = "${canvas.offsetLeft}px"
        root.style.top = "${canvas.offsetTop}px"
        val told = layers.keys.map { owner -> owner to describe(owner, density()) }
        fonts.look(told.asSequence().flatMap { (_, all) -> all }.flatMap { sequenceOf(it.label, it.text) })
        val modal = told.map { (owner, _) -> isModal(owner) }
        tellOpen(modal.count { it })
        val top = modal.lastIndexOf(true).coerceAtLeast(0)
        var focus: AccessibilityNode? = null
        told.forEachIndexed { place, (owner, all) ->
            layers[owner]?.show(if (place < top) emptyList() else all)
            if (place >= top) focus = all.lastOrNull { it.isFocused } ?: focus
        }
        tellFocus(focus)
    }

    private fun tellFocus(now: AccessibilityNode?) {
        input.call(now?.takeIf { it.isField }?.label.orEmpty())
        val id = now?.id.orEmpty()
        if (id == focused) return
        focused = id
        if (id.isEmpty()) {
            canvas.removeAttribute("aria-activedescendant")
        } else {
            canvas.setAttribute("aria-activedescendant", id)
        }
    }

    private fun isModal(owner: SemanticsOwner): Boolean = owner.rootSemanticsNode.let { root ->
        val configs = listOf(root.config) + root.children.map { it.config }
        configs.any {
            it.getOrNull(SemanticsProperties.IsDialog) != null ||
                it.getOrNull(SemanticsProperties.IsPopup) != null
        }
    }

    private companion object {
        /** Milliseconds: no speech output is faster, and a run changes a lot in each frame. */
        const val PAUSE = 200
        val STYLE = mapOf(
            "position" to "absolute",
            "width" to "100%",
            "height" to "100%",
            "opacity" to "0",
            "overflow" to "hidden",
            "pointer-events" to "none",
        )
    }
}
