package robotran.robolang.run

import robotran.brick.kind.BrickKind
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.allStatements
import robotran.robolang.words.BrickDialect

/** Whether a program stops the wheels before it ends: if they [may turn][mayTurnAtEnd] then and would roll on. */
internal fun stopsAtEnd(tree: SyntaxTree, brick: BrickKind): Boolean =
    BrickDialect.of(brick).rollsOn && mayTurnAtEnd(tree)

/** Whether the wheels may turn when a program ends. */
internal fun mayTurnAtEnd(tree: SyntaxTree): Boolean =
    allStatements(tree).any { it is Command.StartMoving || it is Command.StartTurning || it is Command.Motor }
