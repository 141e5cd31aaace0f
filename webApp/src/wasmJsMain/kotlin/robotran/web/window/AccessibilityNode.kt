package robotran.web.window

import androidx.compose.ui.semantics.CustomAccessibilityAction
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsNode
import androidx.compose.ui.semantics.SemanticsOwner
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.state.ToggleableState
import robotran.uikit.*

/**
 * A semantics node as HTML.
 *
 * @property id the key of its element; stable while the node exists.
 * @property tag the element's name.
 * @property attributes the element's attributes, without those of [place].
 * @property text its content; for a field, its value.
 * @property place its bounds, as the values of `left`, `top`, `width` and `height`.
 * @property node the node that performs actions.
 * @property action its action; null for the click action of [node].
 */
internal class AccessibilityNode(
    val id: String,
    val tag: String,
    val label: String,
    val attributes: Map<String, String>,
    val text: String,
    val place: List<String>,
    val node: SemanticsNode,
    val isFocused: Boolean,
    val action: CustomAccessibilityAction? = null,
) {
    val isField: Boolean get() = tag == "textarea"
}

/** All nodes of [owner] in reading order. [density] is device pixels per CSS pixel. */
internal fun describe(owner: SemanticsOwner, density: Float): List<AccessibilityNode> =
    buildList { describe(owner.rootSemanticsNode, density, this) }

private fun describe(node: SemanticsNode, density: Float, all: MutableList<AccessibilityNode>) {
    if (!node.layoutInfo.isPlaced) return
    describeAlone(node, density)?.let { all += it }
    actionsOf(node).forEachIndexed { number, action ->
        val attributes = mapOf("type" to "button", "tabindex" to "-1")
        val id = "${idOf(node)}-$number"
        all +=
            AccessibilityNode(
                id,
                "button",
                action.label,
                attributes,
                action.label,
                placeOf(node, density),
                node,
                isFocused = false,
                action,
            )
    }
    val first = all.size
    node.children.forEach { describe(it, density, all) }
    if (node.config.getOrNull(IsTreeKey) == true) all.add(first, treeOf(node, all.drop(first), density))
}

/** The tree that has all of [inside], which are its siblings in the page. */
private fun treeOf(node: SemanticsNode, inside: List<AccessibilityNode>, density: Float): AccessibilityNode {
    val attributes = buildMap {
        put("role", "tree")
        put("aria-owns", inside.joinToString(" ") { it.id })
        node.parent?.let { put("aria-labelledby", idOf(it)) }
        node.config.getOrNull(SemanticsProperties.TestTag)?.let { put("data-tag", it) }
    }
    return AccessibilityNode(idOf(node), "div", "", attributes, "", placeOf(node, density), node, isFocused = false)
}

/**
 * Each action is a button. An element of a tree has them all only while it is selected, since they would hide the tree;
 * otherwise it has the last one, which shows them.
 */
private fun actionsOf(node: SemanticsNode): List<CustomAccessibilityAction> {
    val all = node.config.getOrNull(SemanticsActions.CustomActions).orEmpty()
    val isUnselected = TreePlaceKey in node.config && node.config.getOrNull(SemanticsProperties.Selected) == false
    return if (isUnselected) all.takeLast(1) else all
}

private fun describeAlone(node: SemanticsNode, density: Float): AccessibilityNode? {
    val config = node.config
    val text = config.getOrNull(SemanticsProperties.EditableText)
    val label = labelOf(node)
    val canBePressed = config.getOrNull(SemanticsActions.OnClick) != null
    val progress = config.getOrNull(SemanticsProperties.ProgressBarRangeInfo)
    val isFocused = config.getOrNull(SemanticsProperties.Focused) == true
    val isLive = config.getOrNull(SemanticsProperties.LiveRegion) != null
    val tag = when {
        text != null -> "textarea"
        progress != null && config.getOrNull(SemanticsActions.SetProgress) != null -> "input"
        canBePressed -> "button"
        config.getOrNull(SemanticsProperties.Heading) != null -> "h2"
        label.isEmpty() && !isLive && config.getOrNull(SemanticsProperties.PaneTitle) == null -> return null
        else -> "div"
    }
    val attributes = buildMap {
        config.getOrNull(SemanticsProperties.TestTag)?.let { put("data-tag", it) }
        if (tag != "div" && tag != "h2") put("tabindex", "-1")
        if (tag == "textarea" || tag == "input" || tag == "button") put("aria-label", label)
        if (config.getOrNull(SemanticsProperties.Disabled) != null) put("aria-disabled", "true")
        if (config.getOrNull(SemanticsProperties.Error) != null) put("aria-invalid", "true")
        roleOf(node, tag)?.let { put("role", it) }
        putState(node)
        if (text != null && config.getOrNull(SemanticsActions.SetText) == null) put("readonly", "")
        // The browser's own field replaces the focused one.
        if (text != null && isFocused) put("aria-hidden", "true")
        if (tag == "button") put("type", "button")
        if (tag == "input" && progress != null) {
            put("type", "range")
            put("min", progress.range.start.toString())
            put("max", progress.range.endInclusive.toString())
            put("step", "any")
        }
    }
    val words =
        text?.text ?: progress?.takeIf { tag == "input" }?.current?.toString()
            ?: label.takeIf { tag != "button" }.orEmpty()
    return AccessibilityNode(idOf(node), tag, label, attributes, words, placeOf(node, density), node, isFocused)
}

private fun labelOf(node: SemanticsNode): String {
    val config = node.config
    // Level and position of an element of a tree are attributes.
    val description = config.getOrNull(TreePlaceKey)?.words
        ?: config.getOrNull(SemanticsProperties.ContentDescription)?.filter { it.isNotEmpty() }?.joinToString(", ")
    val text = config.getOrNull(SemanticsProperties.Text)?.joinToString(" ") { it.text }
    val isField = config.getOrNull(SemanticsProperties.EditableText) != null
    val words = listOf(
        if (isField) listOfNotNull(description, text).joinToString(", ") else description?.ifEmpty { null } ?: text,
        config.getOrNull(SemanticsProperties.PaneTitle)?.takeIf { description == null && text == null },
        config.getOrNull(SemanticsProperties.StateDescription),
        config.getOrNull(SemanticsProperties.Error),
    )
    return words.filterNot { it.isNullOrEmpty() }.filterNotNull().reduceOrNull(::together).orEmpty()
}

/** A sentence and a state read as two sentences, words as a list. */
private fun together(words: String, more: String): String =
    if (words.last() in SENTENCE_ENDS) "$words $more" else "$words, $more"

private const val SENTENCE_ENDS = ".!?"

private fun roleOf(node: SemanticsNode, tag: String): String? {
    val config = node.config
    if (config.getOrNull(TreePlaceKey) != null) return "treeitem"
    return when (config.getOrNull(SemanticsProperties.Role)) {
        Role.Checkbox -> "checkbox"
        Role.Switch -> "switch"
        Role.RadioButton -> "radio"
        Role.Tab -> "tab"
        Role.Image -> "img".takeIf { tag == "div" }
        else -> null
    } ?: "dialog".takeIf { tag == "div" && config.getOrNull(SemanticsProperties.PaneTitle) != null }
}

private fun MutableMap<String, String>.putState(node: SemanticsNode) {
    val config = node.config
    val role = config.getOrNull(SemanticsProperties.Role)
    config.getOrNull(SemanticsProperties.ToggleableState)?.let {
        val word = when (it) {
            ToggleableState.On -> "true"
            ToggleableState.Off -> "false"
            ToggleableState.Indeterminate -> "mixed"
        }
        put(if (role == Role.Checkbox || role == Role.Switch) "aria-checked" else "aria-pressed", word)
    }
    config.getOrNull(SemanticsProperties.Selected)?.let {
        val name = when {
            role == Role.RadioButton -> "aria-checked"
            role == Role.Tab || TreePlaceKey in config -> "aria-selected"
            else -> "aria-pressed"
        }
        put(name, it.toString())
    }
    config.getOrNull(TreePlaceKey)?.let {
        put("aria-level", "${it.level}")
        put("aria-posinset", "${it.position}")
        put("aria-setsize", "${it.siblings}")
        it.isOpen?.let { open -> put("aria-expanded", "$open") }
    }
    if (role == Role.DropdownList) put("aria-haspopup", "menu")
    config.getOrNull(SemanticsProperties.LiveRegion)?.let {
        put("aria-live", if (it == LiveRegionMode.Assertive) "assertive" else "polite")
    }
}

private fun idOf(node: SemanticsNode) = "robotran-${node.id}"

private fun placeOf(node: SemanticsNode, density: Float): List<String> {
    val corner = node.positionInWindow
    return listOf(corner.x, corner.y, node.size.width.toFloat(), node.size.height.toFloat()).map {
        "${(it / density).toInt()}px"
    }
}
