package robotran.ecj;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.eclipse.jdt.internal.compiler.ASTVisitor;
import org.eclipse.jdt.internal.compiler.ast.ASTNode;
import org.eclipse.jdt.internal.compiler.ast.ArrayAllocationExpression;
import org.eclipse.jdt.internal.compiler.ast.ArrayInitializer;
import org.eclipse.jdt.internal.compiler.ast.BinaryExpression;
import org.eclipse.jdt.internal.compiler.ast.CastExpression;
import org.eclipse.jdt.internal.compiler.ast.ClassLiteralAccess;
import org.eclipse.jdt.internal.compiler.ast.CompoundAssignment;
import org.eclipse.jdt.internal.compiler.ast.DoStatement;
import org.eclipse.jdt.internal.compiler.ast.EqualExpression;
import org.eclipse.jdt.internal.compiler.ast.Expression;
import org.eclipse.jdt.internal.compiler.ast.ForStatement;
import org.eclipse.jdt.internal.compiler.ast.InstanceOfExpression;
import org.eclipse.jdt.internal.compiler.ast.OperatorIds;
import org.eclipse.jdt.internal.compiler.ast.PostfixExpression;
import org.eclipse.jdt.internal.compiler.ast.PrefixExpression;
import org.eclipse.jdt.internal.compiler.ast.SwitchStatement;
import org.eclipse.jdt.internal.compiler.ast.UnaryExpression;
import org.eclipse.jdt.internal.compiler.ast.WhileStatement;
import org.eclipse.jdt.internal.compiler.impl.Constant;
import org.eclipse.jdt.internal.compiler.lookup.BlockScope;
import org.eclipse.jdt.internal.compiler.lookup.TypeBinding;
import org.eclipse.jdt.internal.compiler.lookup.TypeIds;

/** What Java allows and the brick's virtual machine does not, or does in another way. */
public final class BrickRules extends ASTVisitor {
    public static final int SWITCH = -1;
    public static final int LONG_ARITHMETIC = -2;
    public static final int FLOAT_REMAINDER = -3;
    public static final int ARRAY_TYPE_TEST = -4;
    public static final int CLASS_LITERAL = -5;
    public static final int TEXT_JOINED_IN_LOOP = -6;

    /** Its arguments are the divisor and what the brick takes it for. */
    public static final int DIVISOR_TOO_LARGE = -7;

    /** Its arguments are the length and the greatest there can be. */
    public static final int ARRAY_TOO_LONG = -8;

    /** A source is too long, or there are too many; its argument is how many UTF-16 characters there can be in all. */
    public static final int SOURCE_TOO_LONG = -9;

    /** Too much is inside each other. */
    public static final int NESTED_TOO_DEEPLY = -10;

    /** The TinyVM keeps an array's length in 9 bits. */
    public static final int LONGEST_ARRAY = 511;

    private final String path;
    private final List<EcjProblem> problems = new ArrayList<>();
    private int loops;

    BrickRules(String path) {
        this.path = path;
    }

    List<EcjProblem> problems() {
        return problems;
    }

    @Override
    public boolean visit(SwitchStatement statement, BlockScope scope) {
        report(SWITCH, true, statement.sourceStart, statement.sourceStart + "switch".length());
        return true;
    }

    @Override
    public boolean visit(ClassLiteralAccess literal, BlockScope scope) {
        report(CLASS_LITERAL, true, literal);
        return true;
    }

    @Override
    public boolean visit(InstanceOfExpression test, BlockScope scope) {
        if (test.type.resolvedType != null && test.type.resolvedType.isArrayType()) {
            report(ARRAY_TYPE_TEST, true, test);
        }
        return true;
    }

    @Override
    public boolean visit(CastExpression cast, BlockScope scope) {
        // A cast that changes nothing leaves no instruction behind.
        if (cast.resolvedType != null && cast.resolvedType.isArrayType() && (cast.bits & ASTNode.GenerateCheckcast) != 0) {
            report(ARRAY_TYPE_TEST, true, cast);
        }
        return true;
    }

    @Override
    public boolean visit(BinaryExpression expression, BlockScope scope) {
        checkOperation(expression, operator(expression), expression.left, expression.right);
        return true;
    }

    @Override
    public boolean visit(EqualExpression expression, BlockScope scope) {
        checkOperation(expression, operator(expression), expression.left, expression.right);
        return true;
    }

    @Override
    public boolean visit(CompoundAssignment assignment, BlockScope scope) {
        checkOperation(assignment, assignment.operator, assignment.lhs, assignment.expression);
        return true;
    }

    @Override
    public boolean visit(PrefixExpression expression, BlockScope scope) {
        checkOperation(expression, expression.operator, expression.lhs, expression.lhs);
        return true;
    }

    @Override
    public boolean visit(PostfixExpression expression, BlockScope scope) {
        checkOperation(expression, expression.operator, expression.lhs, expression.lhs);
        return true;
    }

    @Override
    public boolean visit(UnaryExpression expression, BlockScope scope) {
        checkOperation(expression, operator(expression), expression.expression, expression.expression);
        return true;
    }

    @Override
    public boolean visit(ArrayAllocationExpression allocation, BlockScope scope) {
        for (Expression dimension : allocation.dimensions) {
            if (dimension != null && isWhole(dimension.constant) && dimension.constant.intValue() > LONGEST_ARRAY) {
                report(ARRAY_TOO_LONG, false, dimension, dimension.constant.intValue(), LONGEST_ARRAY);
            }
        }
        return true;
    }

    @Override
    public boolean visit(ArrayInitializer initializer, BlockScope scope) {
        if (initializer.expressions != null && initializer.expressions.length > LONGEST_ARRAY) {
            report(ARRAY_TOO_LONG, false, initializer, initializer.expressions.length, LONGEST_ARRAY);
        }
        return true;
    }

    @Override
    public boolean visit(WhileStatement loop, BlockScope scope) {
        loops++;
        return true;
    }

    @Override
    public void endVisit(WhileStatement loop, BlockScope scope) {
        loops--;
    }

    @Override
    public boolean visit(DoStatement loop, BlockScope scope) {
        loops++;
        return true;
    }

    @Override
    public void endVisit(DoStatement loop, BlockScope scope) {
        loops--;
    }

    @Override
    public boolean visit(ForStatement loop, BlockScope scope) {
        loops++;
        return true;
    }

    @Override
    public void endVisit(ForStatement loop, BlockScope scope) {
        loops--;
    }

    private void checkOperation(Expression operation, int operator, Expression left, Expression right) {
        if (operation.constant != Constant.NotAConstant || left.resolvedType == null || right.resolvedType == null) {
            return;
        }
        boolean joins = operator == OperatorIds.PLUS && (isText(left.resolvedType) || isText(right.resolvedType));
        boolean remainder = operator == OperatorIds.REMAINDER;
        if (joins) {
            if (loops > 0) {
                report(TEXT_JOINED_IN_LOOP, false, operation);
            }
        } else if (isLong(left.resolvedType) || isLong(right.resolvedType) && !isShift(operator)) {
            report(LONG_ARITHMETIC, true, operation);
        } else if (remainder && (isFraction(left.resolvedType) || isFraction(right.resolvedType))) {
            report(FLOAT_REMAINDER, true, operation);
        } else if ((remainder || operator == OperatorIds.DIVIDE) && !isFraction(left.resolvedType) && isWhole(right.constant)) {
            int divisor = right.constant.intValue();
            if (divisor != (short) divisor) {
                report(DIVISOR_TOO_LARGE, false, right, divisor, (short) divisor);
            }
        }
    }

    private void report(int number, boolean error, ASTNode node, int... arguments) {
        report(number, error, node.sourceStart, node.sourceEnd + 1, arguments);
    }

    private void report(int number, boolean error, int start, int end, int... arguments) {
        String[] texts = new String[arguments.length];
        for (int i = 0; i < arguments.length; i++) {
            texts[i] = Integer.toString(arguments[i]);
        }
        problems.add(new EcjProblem(path, number, error, false, start, end, "", Arrays.asList(texts), Collections.emptyList()));
    }

    private static int operator(ASTNode node) {
        return (node.bits & ASTNode.OperatorMASK) >> ASTNode.OperatorSHIFT;
    }

    private static boolean isShift(int operator) {
        return operator == OperatorIds.LEFT_SHIFT || operator == OperatorIds.RIGHT_SHIFT || operator == OperatorIds.UNSIGNED_RIGHT_SHIFT;
    }

    private static boolean isText(TypeBinding type) {
        return type.id == TypeIds.T_JavaLangString;
    }

    private static boolean isLong(TypeBinding type) {
        return type.id == TypeIds.T_long;
    }

    private static boolean isFraction(TypeBinding type) {
        return type.id == TypeIds.T_float || type.id == TypeIds.T_double;
    }

    private static boolean isWhole(Constant constant) {
        return constant != null && constant != Constant.NotAConstant
                && (constant.typeID() == TypeIds.T_int || constant.typeID() == TypeIds.T_short
                        || constant.typeID() == TypeIds.T_byte || constant.typeID() == TypeIds.T_char);
    }
}
