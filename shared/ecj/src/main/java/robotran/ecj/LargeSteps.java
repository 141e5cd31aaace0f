package robotran.ecj;

import org.eclipse.jdt.internal.compiler.ASTVisitor;
import org.eclipse.jdt.internal.compiler.ast.CompoundAssignment;
import org.eclipse.jdt.internal.compiler.ast.OperatorIds;
import org.eclipse.jdt.internal.compiler.ast.SingleNameReference;
import org.eclipse.jdt.internal.compiler.lookup.BlockScope;
import org.eclipse.jdt.internal.compiler.lookup.LocalVariableBinding;
import org.eclipse.jdt.internal.compiler.lookup.TypeIds;

/**
 * Finds additions such as {@code i += 128} to a local variable. The compilers that leJOS works with make of them one
 * instruction with two bytes for the number, which leJOS's linker refuses.
 */
final class LargeSteps extends ASTVisitor {
    private final BrickReport report;

    LargeSteps(BrickReport report) {
        this.report = report;
    }

    @Override
    public boolean visit(CompoundAssignment assignment, BlockScope scope) {
        if (isWholeLocal(assignment) && isLarge(assignment)) {
            report.refuse(BrickProblem.LARGE_STEP, assignment);
        }
        return true;
    }

    private static boolean isWholeLocal(CompoundAssignment assignment) {
        if (!(assignment.lhs instanceof SingleNameReference)) {
            return false;
        }
        SingleNameReference name = (SingleNameReference) assignment.lhs;
        return name.binding instanceof LocalVariableBinding
                && name.resolvedType != null
                && name.resolvedType.id == TypeIds.T_int;
    }

    /** Whether the sum has a constant for which one byte is too short, but two are enough. */
    private static boolean isLarge(CompoundAssignment assignment) {
        boolean isPlus = assignment.operator == OperatorIds.PLUS;
        if (!isPlus && assignment.operator != OperatorIds.MINUS || !BrickOperations.isWhole(assignment.expression.constant)) {
            return false;
        }
        int number = assignment.expression.constant.intValue();
        int step = isPlus ? number : -number;
        return step == (short) step && step != (byte) step;
    }
}
