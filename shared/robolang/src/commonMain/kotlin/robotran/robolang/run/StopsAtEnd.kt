package robotran.robolang.run

import robotran.brick.kind.BrickKind
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.allStatements

/**
 * Whether a program stops the wheels before it ends: if they may turn then. An RCX brakes by itself, but the motors of
 * an NXT roll on.
 */
internal fun stopsAtEnd(tree: SyntaxTree, brick: BrickKind): Boolean = brick == BrickKind.NXT &&
    allStatements(tree).any { it is Command.StartMoving || it is Command.StartTurning || it is Command.Motor }
