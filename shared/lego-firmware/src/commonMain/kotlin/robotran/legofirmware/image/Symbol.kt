package robotran.legofirmware.image

/** @property code the number of the kind in an image. */
enum class SymbolKind(val code: Int) {
    TASK(0),
    SUB(1),
    VARIABLE(2),
    ;

    companion object {
        fun of(code: Int): SymbolKind? = entries.find { it.code == code }
    }
}

/**
 * The name of a task, subroutine or variable. A variable may have several names, because a compiler uses its place again.
 *
 * @property number of the task, subroutine or variable, 0..255.
 * @property name at most [FirmwareLimits.NAME_CHARACTERS] characters, each at most U+00FF and none U+0000.
 */
data class Symbol(val kind: SymbolKind, val number: Int, val name: String)
