package robotran.editing

import robotran.language.history.History
import robotran.world.geometry.Point

/**
 * The state of an editor: what is edited, its history, and the drag that goes on. Each edit makes the next state.
 *
 * @param S what undo restores: what is edited, and what is chosen.
 * @param H what can be dragged.
 * @param E the editor itself.
 */
interface Editor<S, H, E : Editor<S, H, E>> {
    val snapshot: S
    val history: History<S>

    /** The current drag; null if there is none. */
    val gesture: Gesture<S, H>?

    /** Whether what is edited is as in [snapshot], whatever is chosen. */
    fun isAsIn(snapshot: S): Boolean

    /** This state with [history], and without the drag. */
    fun released(history: History<S>): E

    /** The state in which [snapshot] is restored, without a drag. */
    fun restored(snapshot: S, history: History<S>): E
}

/** The user drags [handle] from [from]; [before] is the state at the start. */
data class Gesture<S, H>(val handle: H, val from: Point, val before: S)

/** The state after the drag, if there is one; all of it is one step. */
fun <S, H, E : Editor<S, H, E>> E.dropped(): E {
    val before = (gesture ?: return this).before
    return released(if (isAsIn(before)) history else history.recorded(before))
}

/** The state without the drag and what it has changed. */
fun <S, H, E : Editor<S, H, E>> E.letGo(): E = gesture?.let { restored(it.before, history) } ?: this

/** One step back; during a drag, that is before the drag. */
fun <S, H, E : Editor<S, H, E>> E.undone(): E {
    if (gesture != null) return letGo()
    val (before, rest) = history.undone { snapshot } ?: return this
    return restored(before, rest)
}

/** One step forth; during a drag, the drag ends as with undo. */
fun <S, H, E : Editor<S, H, E>> E.redone(): E {
    if (gesture != null) return letGo()
    val (next, rest) = history.redone { snapshot } ?: return this
    return restored(next, rest)
}
