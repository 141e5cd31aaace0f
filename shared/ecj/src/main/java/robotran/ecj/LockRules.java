package robotran.ecj;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import org.eclipse.jdt.internal.compiler.ASTVisitor;
import org.eclipse.jdt.internal.compiler.ast.AbstractMethodDeclaration;
import org.eclipse.jdt.internal.compiler.ast.ConstructorDeclaration;
import org.eclipse.jdt.internal.compiler.ast.Initializer;
import org.eclipse.jdt.internal.compiler.ast.MessageSend;
import org.eclipse.jdt.internal.compiler.ast.MethodDeclaration;
import org.eclipse.jdt.internal.compiler.ast.SynchronizedStatement;
import org.eclipse.jdt.internal.compiler.lookup.BlockScope;
import org.eclipse.jdt.internal.compiler.lookup.ClassScope;
import org.eclipse.jdt.internal.compiler.lookup.MethodBinding;
import org.eclipse.jdt.internal.compiler.lookup.MethodScope;
import org.eclipse.jdt.internal.compiler.lookup.TypeIds;

/**
 * Finds {@code synchronized} methods that a brick runs without a lock. Its virtual machine locks only for the
 * instruction {@code invokevirtual}, not for private and static methods and calls through {@code super}.
 */
final class LockRules extends ASTVisitor {
    private static final List<String> MONITOR_METHODS = Arrays.asList("wait", "notify", "notifyAll");

    private final BrickReport report;
    private final Deque<Body> bodies = new ArrayDeque<>();

    LockRules(BrickReport report) {
        this.report = report;
    }

    /** The code of a method, a constructor or an initialiser. */
    private static final class Body {
        /** Whether it runs with the lock of its object. */
        final boolean locks;

        /** How many blocks around the current place lock its object. */
        int locksAround;

        /** The first method that needs the lock and is called without it; empty if there is none. */
        String monitorCall = "";

        Body(boolean locks) {
            this.locks = locks;
        }

        boolean hasLock() {
            return locks || locksAround > 0;
        }
    }

    @Override
    public boolean visit(MethodDeclaration method, ClassScope scope) {
        bodies.push(new Body(isSynchronized(method) && !isUnlocked(method.binding)));
        return true;
    }

    @Override
    public void endVisit(MethodDeclaration method, ClassScope scope) {
        Body body = bodies.pop();
        if (isSynchronized(method) && isUnlocked(method.binding)) {
            report.warn(
                BrickProblem.UNLOCKED_METHOD,
                method.sourceStart,
                method.sourceStart + method.selector.length,
                new String(method.selector),
                method.binding.isStatic() ? "static" : "private",
                body.monitorCall);
        }
    }

    @Override
    public boolean visit(ConstructorDeclaration constructor, ClassScope scope) {
        bodies.push(new Body(false));
        return true;
    }

    @Override
    public void endVisit(ConstructorDeclaration constructor, ClassScope scope) {
        bodies.pop();
    }

    @Override
    public boolean visit(Initializer initializer, MethodScope scope) {
        bodies.push(new Body(false));
        return true;
    }

    @Override
    public void endVisit(Initializer initializer, MethodScope scope) {
        bodies.pop();
    }

    @Override
    public boolean visit(SynchronizedStatement block, BlockScope scope) {
        count(block, 1);
        return true;
    }

    @Override
    public void endVisit(SynchronizedStatement block, BlockScope scope) {
        count(block, -1);
    }

    @Override
    public boolean visit(MessageSend call, BlockScope scope) {
        Body body = bodies.peek();
        if (call.binding == null || !call.binding.isValidBinding() || body == null || body.hasLock()) {
            return true;
        }
        String name = new String(call.selector);
        if (call.receiver.isSuper() && call.binding.isSynchronized() && !call.binding.isStatic()) {
            int start = (int) (call.nameSourcePosition >>> 32);
            report.warn(BrickProblem.UNLOCKED_SUPER_CALL, start, start + name.length(), name);
        } else if (call.receiver.isThis() && isMonitorMethod(call.binding) && body.monitorCall.isEmpty()) {
            body.monitorCall = name;
        }
        return true;
    }

    private void count(SynchronizedStatement block, int change) {
        if (block.expression != null && block.expression.isThis() && !bodies.isEmpty()) {
            bodies.peek().locksAround += change;
        }
    }

    private static boolean isSynchronized(AbstractMethodDeclaration method) {
        return method.binding != null && method.binding.isSynchronized();
    }

    private static boolean isUnlocked(MethodBinding method) {
        return method.isPrivate() || method.isStatic();
    }

    private static boolean isMonitorMethod(MethodBinding method) {
        return method.declaringClass.id == TypeIds.T_JavaLangObject
                && MONITOR_METHODS.contains(new String(method.selector));
    }
}
