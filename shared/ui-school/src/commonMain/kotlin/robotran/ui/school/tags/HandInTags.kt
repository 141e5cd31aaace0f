package robotran.ui.school.tags

import robotran.workshop.state.HandInOrder

/** The tags of the hand-ins of a class, by which tests and the page find what is on the screen. */
object HandInTags {
    const val HAND_IN = "hand-in"
    const val HAND_INS = "hand-ins"
    const val HAND_INS_CANCEL = "hand-ins-cancel"
    const val HAND_INS_CHOOSE = "hand-ins-choose"
    const val HAND_INS_COUNTS = "hand-ins-counts"
    const val HAND_INS_CSV = "hand-ins-csv"
    const val HAND_INS_EMPTY = "hand-ins-empty"
    const val HAND_INS_FEEDBACK = "hand-ins-feedback"
    const val HAND_INS_GO_ON = "hand-ins-go-on"
    const val HAND_INS_HTML = "hand-ins-html"
    const val HAND_INS_LINKS = "hand-ins-links"
    const val HAND_INS_PASTE = "hand-ins-paste"
    const val HAND_INS_PASTE_CANCEL = "hand-ins-paste-cancel"
    const val HAND_INS_PASTE_DONE = "hand-ins-paste-done"
    const val HAND_INS_PROGRESS = "hand-ins-progress"
    const val HAND_INS_REMARK = "hand-ins-remark"
    const val HAND_INS_REMOVE = "hand-ins-remove"
    const val HAND_INS_REMOVE_CANCEL = "hand-ins-remove-cancel"
    const val HAND_INS_REMOVE_DONE = "hand-ins-remove-done"
    const val HAND_INS_SCAN = "hand-ins-scan"
    const val HAND_INS_SCAN_PICTURES = "hand-ins-scan-pictures"
    const val HAND_INS_STATUS = "hand-ins-status"
    const val HAND_INS_TOLD = "hand-ins-told"
    const val HAND_INS_TOLD_CLOSE = "hand-ins-told-close"
    const val HAND_INS_UNDO = "hand-ins-undo"
    const val HAND_IN_BESIDE = "hand-in-beside"
    const val HAND_IN_BESIDE_CANCEL = "hand-in-beside-cancel"
    const val HAND_IN_BESIDE_OTHER = "hand-in-beside-other"
    const val HAND_IN_COMMENT = "hand-in-comment"
    const val HAND_IN_FEEDBACK = "hand-in-feedback"
    const val HAND_IN_LIST = "hand-in-list"
    const val HAND_IN_MORE_RUNS = "hand-in-more-runs"
    const val HAND_IN_NEXT = "hand-in-next"
    const val HAND_IN_PREVIOUS = "hand-in-previous"
    const val HAND_IN_PROGRAM = "hand-in-program"
    const val HAND_IN_REMOVE = "hand-in-remove"
    const val HAND_IN_REPLAY = "hand-in-replay"
    const val HAND_IN_REPLAY_OWN = "hand-in-replay-own"

    fun beside(index: Int) = "hand-in-beside-$index"

    fun besideChoice(index: Int) = "hand-in-beside-choice-$index"

    fun order(order: HandInOrder) = "hand-ins-order-${order.name.lowercase()}"

    fun replay(world: String, seed: Int) = "hand-in-replay-$world-$seed"

    fun row(index: Int) = "hand-in-row-$index"

    fun rowRemove(index: Int) = "hand-in-row-remove-$index"

    fun rowReplay(index: Int) = "hand-in-row-replay-$index"

    fun run(world: String, seed: Int) = "hand-in-run-$world-$seed"
}
