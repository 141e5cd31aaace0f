package robotran.ui.school.tags

import robotran.brick.kind.BrickKind
import robotran.brick.kind.BuggyKind

/** The tags of projects and their dialogs, by which tests and the page find what is on the screen. */
object DocumentTags {
    const val CHANGED_AS = "changed-as"
    const val CHANGED_OVER = "changed-over"
    const val CHANGED_THEIRS = "changed-theirs"
    const val DELETE_UNDO = "delete-undo"
    const val DOCUMENT_CANCEL = "document-cancel"
    const val DOCUMENT_DONE = "document-done"
    const val DOCUMENT_TEXT = "document-text"
    const val DOCUMENT_TROUBLE = "document-trouble"
    const val KIT = "kit"
    const val LESS = "less"
    const val LINK_COPY = "link-copy"
    const val LINK_LENGTH = "link-length"
    const val LINK_LOCAL = "link-local"
    const val LINK_SHARE = "link-share"
    const val LINK_TEXT = "link-text"
    const val LOSS_GO_ON = "loss-go-on"
    const val LOSS_SAVE_AS = "loss-save-as"
    const val MORE = "more"
    const val MY_WORK = "my-work"
    const val NEW = "new"
    const val NEW_ROBOT = "new-robot"
    const val NEWER_FILE = "newer-file"
    const val NEWER_TIMES = "newer-times"
    const val NEWER_WORK = "newer-work"
    const val OPEN = "open"
    const val OPEN_LINK = "open-link"
    const val PROGRAM_FILE = "program-file"
    const val QR_CODE = "qr-code"
    const val QR_CODE_LARGE = "qr-code-large"
    const val QR_LARGE_CLOSE = "qr-large-close"
    const val QR_LARGE_VIEW = "qr-large-view"
    const val QR_SHOW_LARGE = "qr-show-large"
    const val QR_TOO_LONG = "qr-too-long"
    const val RENAME = "rename"
    const val RENAME_CANCEL = "rename-cancel"
    const val RENAME_DONE = "rename-done"
    const val REPLAY = "replay"
    const val SAVE = "save"
    const val SAVE_AS = "save-as"
    const val SHARE_LINK = "share-link"
    const val SHARE_SAVE_AS = "share-save-as"
    const val SHARE_SITE = "share-site"
    const val SHOW = "show"
    const val STOPPED_HELP = "stopped-help"
    const val STOPPED_MY_WORK = "stopped-my-work"
    const val STOPPED_OPEN = "stopped-open"
    const val STOPPED_SAVE = "stopped-save"
    const val TROUBLE = "trouble"
    const val VERSION = "version"
    const val WORKS_EMPTY = "works-empty"
    const val WORKS_NEW = "works-new"
    const val WORKS_NEW_ROBOT = "works-new-robot"
    const val WORKS_NOTICE = "works-notice"
    const val WORK_MENU = "work-menu"
    const val WORK_MENU_ITEMS = "work-menu-items"

    fun actions(id: String) = "actions-$id"

    fun delete(id: String) = "delete-$id"

    fun duplicate(id: String) = "duplicate-$id"

    fun menuItem(tag: String) = "work-$tag"

    fun rename(id: String) = "rename-$id"

    fun robot(buggy: BuggyKind) = "buggy-${buggy.word}"

    fun robot(brick: BrickKind) = "robot-${brick.name.lowercase().replace('_', '-')}"

    fun work(id: String) = "work-$id"
}
