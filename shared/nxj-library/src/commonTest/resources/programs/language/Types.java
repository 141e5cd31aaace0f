import java.util.ArrayList;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;

/** Generics, boxing, arrays of all kinds, and tests of types. */
public class Types {
    interface Shape { double area(); }

    static class Square implements Shape, Comparable<Square> {
        final int side;
        Square(int side) { this.side = side; }
        public double area() { return side * side; }
        public int compareTo(Square other) { return side - other.side; }
    }

    static <T extends Comparable<T>> T largest(List<T> list) {
        T best = null;
        for (T item : list) if (best == null || item.compareTo(best) > 0) best = item;
        return best;
    }

    static int sum(int... numbers) {
        int sum = 0;
        for (int number : numbers) sum += number;
        return sum;
    }

    public static void main(String[] args) {
        List<Square> squares = new ArrayList<Square>();
        for (int i = 3; i > 0; i--) squares.add(new Square(i));
        System.out.println(largest(squares).area()); // expect 9.0
        Map<String, Integer> ages = new HashMap<String, Integer>();
        ages.put("Ada", 36);
        ages.put("Bob", 7);
        int total = 0;
        List<Integer> known = new ArrayList<Integer>();
        known.add(ages.get("Ada"));
        known.add(ages.get("Bob"));
        for (Iterator<Integer> i = known.iterator(); i.hasNext();) total += i.next();
        System.out.println(total + " " + ages.get("Ada") + " " + ages.containsKey("Eve")); // expect 43 36 false
        System.out.println(sum() + sum(1) + sum(1, 2, 3)); // expect 7
        Object[] objects = {"text", 5, 2.5, new int[2], new String[] {"a"}, null, 'c', 3L};
        String kinds = "";
        for (Object object : objects) kinds += kind(object);
        System.out.println(kinds); // expect TIDNS0?L
        int[][][] cube = new int[2][3][4];
        cube[1][2][3] = 9;
        System.out.println(cube.length + cube[0].length + cube[1][2].length + cube[1][2][3]); // expect 18
        long[][] wide = new long[2][2];
        wide[1][1] = 1L << 33;
        System.out.println(wide[1][0] + wide[1][1]); // expect 8589934592
        int[] copy = new int[] {1, 2, 3}.clone();
        copy[0] = 9;
        System.out.println(copy[0] + copy.length); // expect 12
        try {
            System.out.println(new int[total - 44].length);
        } catch (NegativeArraySizeException e) {
            System.out.println("negative"); // expect negative
        }
        try {
            Shape shape = (Shape) objects[0];
            System.out.println(shape.area());
        } catch (ClassCastException e) {
            System.out.println("cast"); // expect cast
        }
        try {
            System.out.println(((int[]) objects[4]).length);
        } catch (ClassCastException e) {
            System.out.println("array cast"); // expect array cast
        }
        byte small = (byte) 200;
        char letter = (char) -1;
        short middle = (short) 70000;
        System.out.println(small + " " + (int) letter + " " + middle); // expect -56 65535 4464
        char[] letters = {'a', 40000};
        System.out.println((int) letters[1] + letters.length); // expect 40002
        System.out.println(100000 / 70000 + " " + -7 / 2 + " " + -7 % 3); // expect 1 -3 -1
        Integer one = 1;
        one++;
        System.out.println(one + new Integer(3)); // expect 5
        System.out.println(String.class == "x".getClass()); // expect true
        System.out.println(new Square(1).getClass() == Square.class); // expect true
        System.out.println("constant" == "con" + "stant"); // expect true
    }

    static String kind(Object object) {
        if (object instanceof String) return "T";
        if (object instanceof Integer) return "I";
        if (object instanceof Double) return "D";
        if (object instanceof Long) return "L";
        if (object instanceof int[]) return "N";
        if (object instanceof Object[]) return "S";
        return object == null ? "0" : "?";
    }
}
