package robotran.ecj.browser;

import java.util.ArrayList;
import java.util.List;
import org.teavm.jso.JSExport;
import robotran.ecj.BrickTarget;
import robotran.ecj.EcjCompiler;
import robotran.ecj.EcjProblem;
import robotran.ecj.EcjResult;
import robotran.ecj.Library;

/**
 * The functions of the WebAssembly module: {@link EcjCompiler} with a library for each target, one compiler and its last
 * result.
 */
public final class EcjModule {
    private static final Library[] LIBRARIES = {new Library(), new Library()};
    private static BrickTarget target = BrickTarget.LEJOS_RCX;
    private static EcjCompiler compiler = fresh();
    private static EcjResult result;
    private static List<String> classNames = new ArrayList<>();

    private EcjModule() {}

    /** TeaVM requires a main method; this module needs none. */
    public static void main(String[] arguments) {}

    /**
     * What is compiled for from now on. Each target keeps its library.
     *
     * @param number that of the {@link BrickTarget}, from 0
     */
    @JSExport
    public static void setTarget(int number) {
        target = BrickTarget.values()[number];
        compiler = fresh();
    }

    /** Clears the target's library, so that another one can be added. */
    @JSExport
    public static void clearLibrary() {
        LIBRARIES[target.ordinal()] = new Library();
        compiler = fresh();
    }

    @JSExport
    public static void addLibraryClass(String internalName, byte[] classFile) {
        LIBRARIES[target.ordinal()].add(internalName, classFile);
    }

    @JSExport
    public static void addSource(String path, String text) {
        compiler.addSource(path, text);
    }

    /** Refuses each use of a class or member of the library in the next compilation. */
    @JSExport
    public static void addGap(String key) {
        compiler.addGap(key);
    }

    /** Compiles the sources and discards them. Returns false if the compiler crashed. */
    @JSExport
    public static boolean compile() {
        result = compiler.compile();
        compiler = fresh();
        classNames = new ArrayList<>(result.classes().keySet());
        return !result.crashed();
    }

    @JSExport
    public static int classCount() {
        return classNames.size();
    }

    @JSExport
    public static String className(int place) {
        return classNames.get(place);
    }

    @JSExport
    public static byte[] classFile(int place) {
        return result.classes().get(classNames.get(place));
    }

    @JSExport
    public static boolean classHasMain(int place) {
        return result.mainClasses().contains(classNames.get(place));
    }

    @JSExport
    public static int problemCount() {
        return result.problems().size();
    }

    @JSExport
    public static String problemPath(int place) {
        return problem(place).path();
    }

    @JSExport
    public static int problemNumber(int place) {
        return problem(place).number();
    }

    @JSExport
    public static boolean problemIsError(int place) {
        return problem(place).error();
    }

    @JSExport
    public static boolean problemIsSyntax(int place) {
        return problem(place).syntax();
    }

    @JSExport
    public static int problemStart(int place) {
        return problem(place).start();
    }

    @JSExport
    public static int problemEnd(int place) {
        return problem(place).end();
    }

    @JSExport
    public static String problemMessage(int place) {
        return problem(place).message();
    }

    @JSExport
    public static int problemArgumentCount(int place) {
        return problem(place).arguments().size();
    }

    @JSExport
    public static String problemArgument(int place, int argument) {
        return problem(place).arguments().get(argument);
    }

    @JSExport
    public static int problemMemberCount(int place) {
        return problem(place).members().size();
    }

    @JSExport
    public static String problemMember(int place, int member) {
        return problem(place).members().get(member);
    }

    private static EcjCompiler fresh() {
        return new EcjCompiler(LIBRARIES[target.ordinal()], target);
    }

    private static EcjProblem problem(int place) {
        return result.problems().get(place);
    }
}
