package robotran.ecj;

import org.eclipse.jdt.internal.compiler.CompilationResult;
import org.eclipse.jdt.internal.compiler.ast.AbstractMethodDeclaration;
import org.eclipse.jdt.internal.compiler.ast.ConstructorDeclaration;
import org.eclipse.jdt.internal.compiler.ast.MethodDeclaration;
import org.eclipse.jdt.internal.compiler.ast.TypeDeclaration;

/**
 * The work that ECJ may do in one compilation; the build makes ECJ count it. A few lines of Java can take a compiler
 * time without end, in more ways than rules could name: code that is copied, types that double, searches of searches.
 * The work is counted, not the time, so that a program is refused everywhere or nowhere. Not thread-safe.
 */
public final class WorkBudget {
    /** Twice what the longest sources take that have no such tricks, and about a second. */
    private static final int STEPS = 50_000_000;

    /** This many elements are copied or allocated in the time of a step: two to the power of it. */
    private static final int ELEMENTS_SHIFT = 3;

    private static boolean limited;
    private static int left;
    private static boolean exceeded;
    private static Object place;

    private WorkBudget() {}

    /** Ends a compilation. */
    static final class Exceeded extends Error {
        private static final long serialVersionUID = 1;

        /** Programs do not see where the compiler was. */
        @Override
        public Throwable fillInStackTrace() {
            return this;
        }
    }

    /** Counts and limits the work from now on. */
    static void begin() {
        limited = true;
        exceeded = false;
        place = null;
        left = STEPS;
    }

    /** Limits the work no longer. */
    static void end() {
        limited = false;
        left = 0;
    }

    /** Whether the work of the last compilation was too much. */
    static boolean exceeded() {
        return exceeded;
    }

    /** The problem that the work of the last compilation was too much, where most of it probably is. */
    static EcjProblem problem(String path) {
        if (place instanceof TypeDeclaration) {
            TypeDeclaration type = (TypeDeclaration) place;
            return problem(type.compilationResult, type.name, type.sourceStart);
        }
        if (place instanceof AbstractMethodDeclaration) {
            AbstractMethodDeclaration method = (AbstractMethodDeclaration) place;
            return problem(method.compilationResult, method.selector, method.sourceStart);
        }
        return EcjProblem.of(path, BrickProblem.TOO_MUCH_WORK, 0, 0, path.substring(path.lastIndexOf('/') + 1));
    }

    private static EcjProblem problem(CompilationResult unit, char[] name, int start) {
        return EcjProblem.of(
            new String(unit.getFileName()), BrickProblem.TOO_MUCH_WORK, start, start + name.length, new String(name));
    }

    /** The compiler begins to compile {@code node}. */
    public static void enter(Object node) {
        if (node instanceof MethodDeclaration || node instanceof ConstructorDeclaration
                || node instanceof TypeDeclaration) {
            place = node;
        }
    }

    /** A method is called, or a loop begins another round. */
    public static void step() {
        left--;
        if (left < 0) {
            stop();
        }
    }

    /** An array of {@code length} elements is created. */
    public static void allocate(int length) {
        spend(length);
    }

    /** Copies as {@link System#arraycopy} does. */
    public static void arraycopy(Object source, int start, Object target, int targetStart, int length) {
        spend(length);
        System.arraycopy(source, start, target, targetStart, length);
    }

    /** A text is copied. */
    public static void text(String text) {
        spend(text == null ? 0 : text.length());
    }

    /** A text is copied. */
    public static void text(char[] text) {
        spend(text == null ? 0 : text.length);
    }

    private static void spend(int elements) {
        left -= elements >> ELEMENTS_SHIFT;
        if (left < 0) {
            stop();
        }
    }

    private static void stop() {
        if (limited) {
            exceeded = true;
            throw new Exceeded();
        }
        left = Integer.MAX_VALUE;
    }
}
