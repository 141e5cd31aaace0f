package robotran.ecj.browser;

import java.util.ArrayList;
import java.util.List;
import org.teavm.jso.JSExport;
import robotran.ecj.EcjCompiler;
import robotran.ecj.EcjProblem;
import robotran.ecj.EcjResult;
import robotran.ecj.Library;

/** The functions of the WebAssembly module: {@link EcjCompiler} with one library, one compiler and its last result. */
public final class EcjModule {
    private static Library library = new Library();
    private static EcjCompiler compiler = new EcjCompiler(library);
    private static EcjResult result;
    private static List<String> classNames = new ArrayList<>();

    private EcjModule() {}

    /** TeaVM requires a main method; this module needs none. */
    public static void main(String[] arguments) {}

    /** Clears the library, so that another one can be added. */
    @JSExport
    public static void clearLibrary() {
        library = new Library();
        compiler = new EcjCompiler(library);
    }

    @JSExport
    public static void addLibraryClass(String internalName, byte[] classFile) {
        library.add(internalName, classFile);
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
        compiler = new EcjCompiler(library);
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

    private static EcjProblem problem(int place) {
        return result.problems().get(place);
    }
}
