public class Boxes {
    static String kind(Object value) {
        if (value instanceof Integer) return "Integer";
        if (value instanceof Long) return "Long";
        if (value instanceof Double) return "Double";
        if (value instanceof Character) return "Character";
        if (value instanceof Boolean) return "Boolean";
        if (value instanceof Byte) return "Byte";
        return "other";
    }

    static String over(long value) {
        return "long";
    }

    static String over(Integer value) {
        return "Integer";
    }

    static String over(Object value) {
        return "Object";
    }

    public static void main(String[] arguments) {
        Integer boxed = 5;
        boxed++;
        boxed += 10;
        int plain = boxed * 2;
        System.out.println(boxed + " " + plain); // expect 16 32
        System.out.println(kind(3) + " " + kind(3L) + " " + kind(3.0) + " " + kind('3') + " " + kind(true) + " " + kind((byte) 3));
        // expect Integer Long Double Character Boolean Byte
        System.out.println(over(3)); // expect long
        System.out.println(over(Integer.valueOf(3))); // expect Integer
        System.out.println(over("3")); // expect Object
        Integer small = 100;
        Integer same = 100;
        System.out.println(small.equals(same)); // expect true
        System.out.println(small.equals(100)); // expect true
        System.out.println(new Integer(100).equals(new Integer(100))); // expect true
        System.out.println(Long.valueOf(3).equals(3)); // expect false
        Character letter = 'x';
        letter++;
        System.out.println(letter); // expect y
        Boolean flag = false;
        if (!flag) System.out.println(flag); // expect false
        Double real = 1.5;
        real /= 2;
        System.out.println(real); // expect 0.75
        Object choice = true ? 1 : "one";
        System.out.println(choice); // expect 1
        System.out.println(true ? 1 : 2.0); // expect 1.0
        Integer none = null;
        try {
            int fails = none;
            System.out.println(fails);
        } catch (NullPointerException missing) {
            System.out.println("none"); // expect none
        }
        int[] counts = new int[3];
        Integer index = 1;
        counts[index]++;
        System.out.println(counts[1]); // expect 1
        System.out.println(boxed.hashCode() + " " + letter.hashCode() + " " + flag.hashCode() + " " + Long.valueOf(1L << 33).hashCode());
        // expect 16 121 1237 2
    }
}
