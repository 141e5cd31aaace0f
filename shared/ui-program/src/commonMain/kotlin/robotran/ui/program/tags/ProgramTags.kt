package robotran.ui.program.tags

import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.language.ShownLanguage
import robotran.projects.ProgramView
import robotran.robolang.words.BlockGroup
import robotran.workshop.state.NoteKind

/** The tags of the room of programs, by which tests and the page find what is on the screen. */
object ProgramTags {
    const val ACTIONS_MORE = "actions-more"
    const val ADD_PROGRAM = "add-program"
    const val BLOCKS = "blocks"
    const val BLOCKS_ADD = "blocks-add"
    const val BLOCKS_BIN = "blocks-bin"
    const val BLOCKS_CHOOSING = "blocks-choosing"
    const val BLOCKS_ERROR = "blocks-error"
    const val BLOCKS_ERROR_CLOSE = "blocks-error-close"
    const val BLOCKS_SAID = "blocks-said"
    const val BLOCK_GROUPS = "block-groups"
    const val BLOCK_MORE = "block-more"
    const val BLOCK_PANE = "block-pane"
    const val BLOCK_SHEET = "block-sheet"
    const val BLOCK_SHEET_CLOSE = "block-sheet-close"
    const val CHOOSE = "choose"
    const val CHOOSING_COPY = "choosing-copy"
    const val CHOOSING_DELETE = "choosing-delete"
    const val CHOOSING_DONE = "choosing-done"
    const val CHOOSING_DUPLICATE = "choosing-duplicate"
    const val CLOSED_PROGRAM = "closed-program"
    const val CLOSED_PROGRAM_CLOSE = "closed-program-close"
    const val CLOSE_PROGRAM = "close-program"
    const val COMPLETIONS = "completions"
    const val COPY = "copy"
    const val CUT = "cut"
    const val DELETE = "delete"
    const val DIGIT_0 = "digit-0"
    const val DOWN = "down"
    const val DUPLICATE = "duplicate"
    const val EDITOR_MORE = "editor-more"
    const val ELSE = "else"
    const val ELSE_IF = "else-if"
    const val EXAMPLES = "examples"
    const val FIND = "find"
    const val FIND_BAR = "find-bar"
    const val FIND_CASE = "find-case"
    const val FIND_CLOSE = "find-close"
    const val FIND_COUNT = "find-count"
    const val FIND_NEXT = "find-next"
    const val FIND_OPEN = "find-open"
    const val FIND_PREVIOUS = "find-previous"
    const val FIND_WORDS = "find-words"
    const val FIX = "fix"
    const val HANDLE_ANCHOR = "handle-anchor"
    const val HANDLE_CARET = "handle-caret"
    const val HELP = "help"
    const val IN = "in"
    const val ITEM_ADD = "item-add"
    const val ITEM_REMOVE = "item-remove"
    const val KEYS = "keys"
    const val LINE = "line"
    const val MISTAKES = "mistakes"
    const val NAME = "name"
    const val NEW_CLASS = "new-class"
    const val NEW_MORE = "new-more"
    const val NEW_NAME = "new-name"
    const val NEXT_MISTAKE = "next-mistake"
    const val NOTE = "note"
    const val NOTE_DELETE = "note-delete"
    const val NOW = "now"
    const val NO_COMPLETIONS = "no-completions"
    const val NUMBER = "number"
    const val NUMBER_DIAL = "number-dial"
    const val NUMBER_DONE = "number-done"
    const val NUMBER_LESS = "number-less"
    const val NUMBER_MORE = "number-more"
    const val NUMBER_NOW = "number-now"
    const val NUMBER_SLIDER = "number-slider"
    const val OTHER_BRICK = "other-brick"
    const val OTHER_BRICK_BEGINNING = "other-brick-beginning"
    const val OUT = "out"
    const val PALETTE_ALL = "palette-all"
    const val PALETTE_BLOCKS = "palette-blocks"
    const val PALETTE_SEARCH = "palette-search"
    const val PARAMETER_ADD = "parameter-add"
    const val PARAMETER_REMOVE = "parameter-remove"
    const val PASTE = "paste"
    const val PROGRAM = "program"
    const val REDO = "redo"
    const val REMARKS = "remarks"
    const val REMARKS_CLOSE = "remarks-close"
    const val REMOVE_CLASS = "remove-class"
    const val REMOVE_ELSE = "remove-else"
    const val RENAME_CANCEL = "rename-cancel"
    const val RENAME_DONE = "rename-done"
    const val RENAME_NAME = "rename-name"
    const val REOPEN_CLOSED = "reopen-closed"
    const val REOPEN_PROGRAM = "reopen-program"
    const val REPLACE = "replace"
    const val REPLACE_ALL = "replace-all"
    const val REPLACE_ONE = "replace-one"
    const val ROBOTS = "robots"
    const val SELECTION_BAR = "selection-bar"
    const val SHOWN_TEXT = "shown-text"
    const val STACK = "stack"
    const val TONE = "tone"
    const val TRANSLATION = "translation"
    const val TRANSLATION_KEEP = "translation-keep"
    const val TRANSLATION_REMARKS = "translation-remarks"
    const val TRANSLATION_SWITCH = "translation-switch"
    const val TRANSLATION_TEXT = "translation-text"
    const val UNDO = "undo"
    const val UNWRAP = "unwrap"
    const val UP = "up"
    const val USE_OTHER_BRICK = "use-other-brick"
    const val VALUE = "value"
    const val VALUE_NAME = "value-name"
    const val VIEW_SWITCH = "view-switch"
    const val WRAP = "wrap"

    fun action(name: String) = "action-$name"

    fun block(key: String) = "block-$key"

    fun blockLine(line: Int) = "block-line-$line"

    fun choice(index: Int) = "choice-$index"

    fun digit(key: Char) = "digit-$key"

    fun done(tag: String) = "$tag-done"

    fun field(tag: String) = "$tag-field"

    fun file(place: Int) = "file-$place"

    fun fold(key: String) = "fold-$key"

    fun form(index: Int) = "form-$index"

    fun group(group: BlockGroup) = "group-${group.name.lowercase()}"

    fun key(sign: String) = "key-$sign"

    fun name(index: Int) = "name-$index"

    fun new(language: ProgramLanguage) = "new-${language.name.lowercase()}"

    fun note(kind: NoteKind) = kind.name.lowercase()

    fun now(block: String) = "now-$block"

    fun program(slot: Int) = "program-$slot"

    fun robot(name: String) = "robot-$name"

    fun selection(command: Enum<*>) = "selection-${command.name.lowercase()}"

    fun socket(start: Int, end: Int) = "socket-$start-$end"

    fun take(block: String) = "take-$block"

    fun words(language: Language) = "words-${language.tag}"

    fun blockWords(language: Language) = "block-words-${language.tag}"

    fun tool(command: Enum<*>) = "tool-${command.name.lowercase()}"

    fun translation(language: ShownLanguage) = "translation-${language.name.lowercase()}"

    fun view(view: ProgramView) = "view-${view.name.lowercase()}"
}
