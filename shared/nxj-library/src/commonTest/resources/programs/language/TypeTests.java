import java.util.ArrayList;
import java.util.Collection;
import java.util.List;

public class TypeTests {
    interface A { }

    interface B extends A { }

    static class C implements B { }

    static class D extends C implements Comparable<D> {
        public int compareTo(D other) {
            return 0;
        }
    }

    static String kinds(Object o) {
        return (o instanceof A ? "A" : "-") + (o instanceof B ? "B" : "-") + (o instanceof C ? "C" : "-")
            + (o instanceof D ? "D" : "-") + (o instanceof Comparable ? "c" : "-") + (o instanceof Object[] ? "[" : "-")
            + (o instanceof int[] ? "i" : "-") + (o instanceof A[] ? "a" : "-") + (o instanceof Cloneable ? "k" : "-")
            + (o instanceof Number ? "n" : "-") + (o instanceof CharSequence ? "s" : "-");
    }

    public static void main(String[] arguments) {
        Object[] all = {new C(), new D(), "text", 3, 2.5, new int[0], new Object[0], new C[0], new D[1][1], null, new char[0]};
        for (Object one : all) System.out.println(kinds(one)); // expect ABC--------
        // expect ABCDc------
        // expect ----c-----s
        // expect ----c----n-
        // expect ----c----n-
        // expect ------i-k--
        // expect -----[--k--
        // expect -----[-ak--
        // expect -----[--k--
        // expect -----------
        // expect --------k--
        Object list = new ArrayList<String>();
        System.out.println((list instanceof List) + " " + (list instanceof Collection) + " " + (list instanceof Iterable)); // expect true true true
        Object[] covariant = new D[2];
        covariant[0] = new D();
        System.out.println(kinds(covariant[0])); // expect ABCDc------
        A[][] nested = new D[2][2];
        System.out.println(nested[1] instanceof D[]); // expect true
        try {
            Object o = new int[2];
            System.out.println(((long[]) o).length);
        } catch (ClassCastException wrong) {
            System.out.println("no long array"); // expect no long array
        }
        try {
            Object o = new C();
            System.out.println(((Comparable<?>) o).hashCode());
        } catch (ClassCastException wrong) {
            System.out.println("cannot be compared"); // expect cannot be compared
        }
    }
}
