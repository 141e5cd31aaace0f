package robotran.ui.school.tags

import robotran.hublink.connection.HubTransport
import robotran.tower.port.TowerKind

/** The tags of sending to a real brick, by which tests and the page find what is on the screen. */
object SendTags {
    const val SEND_AGAIN = "send-again"
    const val SEND_ANNOUNCER = "send-announcer"
    const val SEND_BLOCK = "send-block"
    const val SEND_BACK = "send-back"
    const val SEND_CANCEL = "send-cancel"
    const val SEND_CHOOSE_BOARD = "send-choose-board"
    const val SEND_CHOOSE_FIRMWARE = "send-choose-firmware"
    const val SEND_CHOOSE_MICROPYTHON = "send-choose-micropython"
    const val SEND_CONFIRM = "send-confirm"
    const val SEND_DATALOG = "send-datalog"
    const val SEND_DRIVE = "send-drive"
    const val SEND_EMPTY_SLOTS = "send-empty-slots"
    const val SEND_FIRMWARE = "send-firmware"
    const val SEND_LINE = "send-line"
    const val SEND_LINE_SWITCH = "send-line-switch"
    const val SEND_MEANING = "send-meaning"
    const val SEND_MESSAGE = "send-message"
    const val SEND_NUMBER = "send-number"
    const val SEND_OTHER_HUB = "send-other-hub"
    const val SEND_OTHER_TOWER = "send-other-tower"
    const val SEND_OUTPUT = "send-output"
    const val SEND_PICTURE = "send-picture"
    const val SEND_PROGRESS = "send-progress"
    const val SEND_READ_DATALOG = "send-read-datalog"
    const val SEND_SAVE_DATALOG = "send-save-datalog"
    const val SEND_ROOM = "send-room"
    const val SEND_SAVE_HEX = "send-save-hex"
    const val SEND_SAVE_PYTHON = "send-save-python"
    const val SEND_SHEET = "send-sheet"
    const val SEND_SHOW_LINE = "send-show-line"
    const val SEND_SHOW_MISTAKE = "send-show-mistake"
    const val SEND_START = "send-start"
    const val SEND_STEP = "send-step"
    const val SEND_STOP = "send-stop"
    const val SEND_TO_SLOTS = "send-to-slots"
    const val SEND_USB = "send-usb"
    const val SEND_WATCH = "send-watch"
    const val SEND_WEAK = "send-weak"
    const val SEND_WHOLE = "send-whole"
    const val SEND_WORDS = "send-words"

    fun hub(index: Int) = "send-hub-$index"

    fun board(index: Int) = "send-board-$index"

    fun look(transport: HubTransport) = "send-look-${transport.name.lowercase()}"

    fun look(kind: TowerKind) = "send-look-${kind.name.lowercase()}"

    fun slot(slot: Int) = "send-slot-$slot"

    fun tower(index: Int) = "send-tower-$index"
}
