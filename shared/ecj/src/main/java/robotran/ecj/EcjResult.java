package robotran.ecj;

import java.util.List;
import java.util.Map;

/** What came of compiling. */
public final class EcjResult {
    private final Map<String, byte[]> classes;
    private final List<String> mainClasses;
    private final List<EcjProblem> problems;
    private final boolean crashed;

    EcjResult(Map<String, byte[]> classes, List<String> mainClasses, List<EcjProblem> problems, boolean crashed) {
        this.classes = classes;
        this.mainClasses = mainClasses;
        this.problems = problems;
        this.crashed = crashed;
    }

    /** The class files by internal name, in the order of the sources; only of sources without errors. */
    public Map<String, byte[]> classes() {
        return classes;
    }

    /** Those with a {@code public static void main(String[])}. */
    public List<String> mainClasses() {
        return mainClasses;
    }

    public List<EcjProblem> problems() {
        return problems;
    }

    /** Whether the compiler gave up because of a mistake of its own; the problems found until then are kept. */
    public boolean crashed() {
        return crashed;
    }
}
