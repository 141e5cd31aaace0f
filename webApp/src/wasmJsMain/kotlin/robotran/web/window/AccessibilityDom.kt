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
    private var timer = 0
    private var isDue = false
    private var isDueSoon = false
    private var awaitedUntil = 0.0
    private var cost = 0.0
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

    /** Called for each key and touch: who has made it waits for what it changes, which is told sooner than other changes. */
    fun awaitChange() {
        awaitedUntil = window.performance.now() + AWAITED
    }

    private fun changed() {
        val isSoon = window.performance.now() < awaitedUntil
        if (isDue && (isDueSoon || !isSoon)) return
        if (isDue) window.clearTimeout(timer)
        isDue = true
        isDueSoon = isSoon
        root.setAttribute(DUE, "")
        val pause = if (isSoon) (cost * MOST_SHARE).toInt().coerceIn(SOON, PAUSE) else PAUSE
        timer = window.setTimeout({
            isDue = false
            root.removeAttribute(DUE)
            val start = window.performance.now()
            show()
            cost = window.performance.now() - start
            null
        }, pause)
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

        /** For what a key or a touch has changed: at least these milliseconds, and so many times what it takes to tell. */
        const val SOON = 16
        const val MOST_SHARE = 8

        /** The milliseconds after a key or a touch in which changes are likely to come of it. */
        const val AWAITED = 400

        /** The attribute that the HTML has while it is older than the screen. */
        const val DUE = "data-due"
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
