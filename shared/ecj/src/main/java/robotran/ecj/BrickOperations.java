package robotran.ecj;

import org.eclipse.jdt.internal.compiler.ast.Expression;
import org.eclipse.jdt.internal.compiler.ast.OperatorIds;
import org.eclipse.jdt.internal.compiler.impl.Constant;
import org.eclipse.jdt.internal.compiler.lookup.TypeBinding;
import org.eclipse.jdt.internal.compiler.lookup.TypeIds;

/** Checks operators for {@link BrickRules}: the operand types they take on a brick, and the size of divisors. */
final class BrickOperations {
    private final BrickReport report;

    BrickOperations(BrickReport report) {
        this.report = report;
    }

    /** @param inLoop whether the operation is inside a loop */
    void check(Expression operation, int operator, Expression left, Expression right, boolean inLoop) {
        if (operation.constant != Constant.NotAConstant || left.resolvedType == null || right.resolvedType == null) {
            return;
        }
        boolean joins = operator == OperatorIds.PLUS && (isText(left.resolvedType) || isText(right.resolvedType));
        boolean remainder = operator == OperatorIds.REMAINDER;
        if (joins) {
            if (isNumber(left.resolvedType) || isNumber(right.resolvedType)) {
                report.warn(BrickProblem.TEXT_AND_NUMBER, operation);
            } else if (inLoop) {
                report.warn(BrickProblem.TEXT_JOINED_IN_LOOP, operation);
            }
        } else if (isLong(left.resolvedType) || isLong(right.resolvedType) && !isShift(operator)) {
            report.refuse(BrickProblem.LONG_ARITHMETIC, operation);
        } else if (remainder && (isFraction(left.resolvedType) || isFraction(right.resolvedType))) {
            report.refuse(BrickProblem.FLOAT_REMAINDER, operation);
        } else if ((remainder || operator == OperatorIds.DIVIDE)
                && !isFraction(left.resolvedType) && isWhole(right.constant)) {
            int divisor = right.constant.intValue();
            if (divisor != (short) divisor) {
                report.warn(BrickProblem.DIVISOR_TOO_LARGE, right, divisor, (short) divisor);
            }
        }
    }

    private static boolean isShift(int operator) {
        return operator == OperatorIds.LEFT_SHIFT || operator == OperatorIds.RIGHT_SHIFT
            || operator == OperatorIds.UNSIGNED_RIGHT_SHIFT;
    }

    private static boolean isText(TypeBinding type) {
        return type.id == TypeIds.T_JavaLangString;
    }

    private static boolean isNumber(TypeBinding type) {
        return type.isNumericType() && type.id != TypeIds.T_char;
    }

    private static boolean isLong(TypeBinding type) {
        return type.id == TypeIds.T_long;
    }

    private static boolean isFraction(TypeBinding type) {
        return type.id == TypeIds.T_float || type.id == TypeIds.T_double;
    }

    static boolean isWhole(Constant constant) {
        return constant != null && constant != Constant.NotAConstant
                && (constant.typeID() == TypeIds.T_int || constant.typeID() == TypeIds.T_short
                        || constant.typeID() == TypeIds.T_byte || constant.typeID() == TypeIds.T_char);
    }
}
