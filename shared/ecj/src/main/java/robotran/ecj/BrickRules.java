package robotran.ecj;

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
import org.eclipse.jdt.internal.compiler.ast.PostfixExpression;
import org.eclipse.jdt.internal.compiler.ast.PrefixExpression;
import org.eclipse.jdt.internal.compiler.ast.SwitchStatement;
import org.eclipse.jdt.internal.compiler.ast.UnaryExpression;
import org.eclipse.jdt.internal.compiler.ast.WhileStatement;
import org.eclipse.jdt.internal.compiler.lookup.BlockScope;

/** Finds Java code that the brick's virtual machine does not support or runs differently. */
final class BrickRules extends ASTVisitor {
    /** TinyVM stores an array's length in 9 bits. */
    private static final int LONGEST_ARRAY = 511;

    private final BrickReport report;
    private final BrickOperations operations;
    private int loops;

    BrickRules(BrickReport report) {
        this.report = report;
        this.operations = new BrickOperations(report);
    }

    @Override
    public boolean visit(SwitchStatement statement, BlockScope scope) {
        report.refuse(BrickProblem.SWITCH, statement.sourceStart, statement.sourceStart + "switch".length());
        return true;
    }

    @Override
    public boolean visit(ClassLiteralAccess literal, BlockScope scope) {
        report.refuse(BrickProblem.CLASS_LITERAL, literal);
        return true;
    }

    @Override
    public boolean visit(InstanceOfExpression test, BlockScope scope) {
        if (test.type.resolvedType != null && test.type.resolvedType.isArrayType()) {
            report.refuse(BrickProblem.ARRAY_TYPE_TEST, test);
        }
        return true;
    }

    @Override
    public boolean visit(CastExpression cast, BlockScope scope) {
        // A redundant cast compiles to no instruction.
        if (cast.resolvedType != null && cast.resolvedType.isArrayType()
                && (cast.bits & ASTNode.GenerateCheckcast) != 0) {
            report.refuse(BrickProblem.ARRAY_TYPE_TEST, cast);
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
            if (dimension != null && BrickOperations.isWhole(dimension.constant)
                    && dimension.constant.intValue() > LONGEST_ARRAY) {
                report.warn(BrickProblem.ARRAY_TOO_LONG, dimension, dimension.constant.intValue(), LONGEST_ARRAY);
            }
        }
        return true;
    }

    @Override
    public boolean visit(ArrayInitializer initializer, BlockScope scope) {
        if (initializer.expressions != null && initializer.expressions.length > LONGEST_ARRAY) {
            report.warn(BrickProblem.ARRAY_TOO_LONG, initializer, initializer.expressions.length, LONGEST_ARRAY);
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
        operations.check(operation, operator, left, right, loops > 0);
    }

    private static int operator(ASTNode node) {
        return (node.bits & ASTNode.OperatorMASK) >> ASTNode.OperatorSHIFT;
    }
}
