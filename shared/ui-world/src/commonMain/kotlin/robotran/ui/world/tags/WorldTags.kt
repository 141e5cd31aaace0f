package robotran.ui.world.tags

import robotran.robotediting.RobotItem
import robotran.workshop.measuring.MeasuringEnd
import robotran.workshop.state.CameraKind
import robotran.workshop.state.SheetElementKind
import robotran.workshop.state.SheetLayer
import robotran.worldediting.AlignSide
import robotran.worldediting.ElementKind
import robotran.worldediting.PaletteItem
import robotran.worldediting.Tool

/** The tags of the room of the world, by which tests and the page find what is on the screen. */
object WorldTags {
    const val ADD_GOAL = "add-goal"
    const val BACKWARD = "backward"
    const val BUILD_ROBOT = "build-robot"
    const val BUMP = "bump"
    const val CARRIED = "carried"
    const val CHOSEN_NAME = "chosen-name"
    const val CHOSEN_TROUBLE = "chosen-trouble"
    const val DELETE = "delete"
    const val CLOSE_WORDS = "close-words"
    const val DUPLICATE = "duplicate"
    const val EDIT = "edit"
    const val EDIT_HINTS = "edit-hints"
    const val EDIT_MENU = "edit-menu"
    const val EDIT_OF_ASSIGNMENT = "edit-of-assignment"
    const val EDIT_OF_ASSIGNMENT_WORDS = "edit-of-assignment-words"
    const val EDIT_PANEL = "edit-panel"
    const val EDIT_SEVERAL = "edit-several"
    const val EDIT_SHEET = "edit-sheet"
    const val EDIT_TO_ASSIGNMENT = "edit-to-assignment"
    const val EDIT_TRY = "edit-try"
    const val EXPLORE = "explore"
    const val EXPLORING_CROSS = "exploring-cross"
    const val FORWARD = "forward"
    const val GOAL_CHANGE = "goal-change"
    const val GOAL_DELETE = "goal-delete"
    const val GOAL_DOWN = "goal-down"
    const val GOAL_IN = "goal-in"
    const val GOAL_OUT = "goal-out"
    const val GOAL_UNWRAP = "goal-unwrap"
    const val GOAL_UP = "goal-up"
    const val GOAL_WRAP = "goal-wrap"
    const val GROUP = "group"
    const val LARGER = "larger"
    const val LIGHT = "light"
    const val MEASURED = "measured"
    const val MENU_ALL = "menu-all"
    const val MENU_ANGLE = "menu-angle"
    const val MENU_COPY = "menu-copy"
    const val MENU_DISCARD = "menu-discard"
    const val MENU_FIT = "menu-fit"
    const val MENU_OTHERS = "menu-others"
    const val MENU_PASTE = "menu-paste"
    const val MENU_ZOOM_IN = "menu-zoom-in"
    const val MENU_ZOOM_OUT = "menu-zoom-out"
    const val MINI_SHEET = "mini-sheet"
    const val NEW_WORLD = "new-world"
    const val PALETTE = "palette"
    const val PREVIEW_END = "preview-end"
    const val ROBOT = "robot"
    const val ROBOT_ADD_CORNER = "robot-add-corner"
    const val ROBOT_BENCH = "robot-bench"
    const val ROBOT_CHOSEN_NAME = "robot-chosen-name"
    const val ROBOT_CHOSEN_TROUBLE = "robot-chosen-trouble"
    const val ROBOT_FIT = "robot-fit"
    const val ROBOT_HINTS = "robot-hints"
    const val ROBOT_ON_SHEET = "robot-on-sheet"
    const val ROBOT_OPEN = "robot-open"
    const val ROBOT_PALETTE = "robot-palette"
    const val ROBOT_PANEL = "robot-panel"
    const val ROBOT_PLAN = "robot-plan"
    const val ROBOT_REMOVE = "robot-remove"
    const val ROBOT_SAVE = "robot-save"
    const val ROBOT_SHEET = "robot-sheet"
    const val ROBOT_SHOW_TROUBLE = "robot-show-trouble"
    const val ROBOT_TURN_LEFT = "robot-turn-left"
    const val ROBOT_TURN_RIGHT = "robot-turn-right"
    const val SHEET_3D = "sheet-3d"
    const val SHEET_FOLLOW = "sheet-follow"
    const val SHEET_FURTHER = "sheet-further"
    const val SHEET_MEASURE = "sheet-measure"
    const val SHEET_NEARER = "sheet-nearer"
    const val HEAR_RUN = "hear-run"
    const val SHEET_SHOW = "sheet-show"
    const val SHEET_SURROUNDINGS = "sheet-surroundings"
    const val SHEET_WHOLE = "sheet-whole"
    const val SHOW = "show"
    const val SHOW_TROUBLE = "show-trouble"
    const val SMALLER = "smaller"
    const val TEMPERATURE = "temperature"
    const val TO_BACK = "to-back"
    const val TO_FRONT = "to-front"
    const val TURN_LEFT = "turn-left"
    const val TURN_RIGHT = "turn-right"
    const val UNGROUP = "ungroup"
    const val WHAT_HAPPENED = "what-happened"
    const val WHERE_AM_I = "where-am-i"
    const val WORDS = "words"
    const val WORDS_SAID = "words-said"
    const val WORLD = "world"
    const val WORLD_EDIT = "world-edit"

    fun align(side: AlignSide) = "align-${side.name.lowercase()}"

    fun camera(kind: CameraKind) = "camera-${kind.name.lowercase()}"

    fun done(tag: String) = "$tag-done"

    fun editTab(tab: Enum<*>) = "tab-edit-${tab.name.lowercase()}"

    fun layer(layer: SheetLayer) = "layer-${layer.name.lowercase()}"

    fun less(tag: String) = "$tag-less"

    fun measure(end: MeasuringEnd) = "measure-${end.name.lowercase()}"

    fun menuGrid(width: String) = "menu-grid-$width"

    fun more(tag: String) = "$tag-more"

    fun palette(item: PaletteItem) = "palette-${item.name.lowercase()}"

    fun redo(tag: String) = "$tag-redo"

    fun robotElement(row: Int) = "robot-element-$row"

    fun robotItem(item: RobotItem) = "robot-item-${item.name.lowercase()}"

    fun robotReady(name: String) = "robot-ready-$name"

    fun robotTab(tab: Enum<*>) = "tab-robot-${tab.name.lowercase()}"

    fun slider(tag: String) = "$tag-slider"

    fun surroundings(tag: String) = "slider-$tag"

    fun thing(kind: ElementKind, number: Int) = "thing-${kind.name.lowercase()}-$number"

    fun thing(kind: SheetElementKind, number: Int) = "thing-${kind.name.lowercase()}-$number"

    fun tool(tool: Tool) = "tool-${tool.name.lowercase()}"

    /** The same among the buttons of the sheet, and in the menu of the view. */
    fun ofControls(tag: String) = "controls-$tag"

    fun ofMenu(tag: String) = "menu-$tag"

    fun undo(tag: String) = "$tag-undo"
}
