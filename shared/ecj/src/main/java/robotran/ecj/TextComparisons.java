package robotran.ecj;

import org.eclipse.jdt.internal.compiler.ASTVisitor;
import org.eclipse.jdt.internal.compiler.ast.ASTNode;
import org.eclipse.jdt.internal.compiler.ast.ArrayReference;
import org.eclipse.jdt.internal.compiler.ast.EqualExpression;
import org.eclipse.jdt.internal.compiler.ast.Expression;
import org.eclipse.jdt.internal.compiler.ast.FieldReference;
import org.eclipse.jdt.internal.compiler.ast.MessageSend;
import org.eclipse.jdt.internal.compiler.ast.NameReference;
import org.eclipse.jdt.internal.compiler.ast.OperatorIds;
import org.eclipse.jdt.internal.compiler.ast.StringLiteral;
import org.eclipse.jdt.internal.compiler.impl.Constant;
import org.eclipse.jdt.internal.compiler.lookup.BlockScope;
import org.eclipse.jdt.internal.compiler.lookup.TypeIds;

/** Finds texts that are compared as objects. leJOS NXJ makes a new object each time a text of the program is used. */
final class TextComparisons extends ASTVisitor {
    private final BrickReport report;

    TextComparisons(BrickReport report) {
        this.report = report;
    }

    @Override
    public boolean visit(EqualExpression comparison, BlockScope scope) {
        // The compiler itself compares constants, by their letters.
        boolean isRunTime = comparison.constant == Constant.NotAConstant;
        if (isRunTime && isText(comparison.left) && isText(comparison.right)) {
            int operator = (comparison.bits & ASTNode.OperatorMASK) >> ASTNode.OperatorSHIFT;
            report.warn(
                BrickProblem.TEXTS_COMPARED,
                comparison.left.sourceStart,
                comparison.right.sourceEnd + 1,
                operator == OperatorIds.EQUAL_EQUAL ? "==" : "!=",
                Integer.toString(isCallable(comparison.left) ? comparison.left.sourceEnd + 1 : -1),
                Integer.toString(comparison.right.sourceStart));
        }
        return true;
    }

    private static boolean isText(Expression expression) {
        return expression.resolvedType != null && expression.resolvedType.id == TypeIds.T_JavaLangString;
    }

    /** Whether {@code .equals} can stand directly behind it. */
    private static boolean isCallable(Expression expression) {
        return (expression.bits & ASTNode.ParenthesizedMASK) != 0 || expression instanceof NameReference
                || expression instanceof FieldReference || expression instanceof MessageSend
                || expression instanceof ArrayReference || expression instanceof StringLiteral;
    }
}
