public class Varargs {
    static int sum(int... numbers) {
        int sum = 0;
        for (int number : numbers) sum += number;
        return sum;
    }

    static String join(String between, Object... parts) {
        StringBuilder joined = new StringBuilder();
        for (int i = 0; i < parts.length; i++) {
            if (i > 0) joined.append(between);
            joined.append(parts[i]);
        }
        return joined.toString();
    }

    static String which(int number) {
        return "one";
    }

    static String which(int... numbers) {
        return "many " + numbers.length;
    }

    public static void main(String... arguments) {
        System.out.println(sum()); // expect 0
        System.out.println(sum(4)); // expect 4
        System.out.println(sum(1, 2, 3)); // expect 6
        System.out.println(sum(new int[] {5, 6})); // expect 11
        System.out.println(join(", ", 1, 'c', "text", 2.5, 7L, true, null)); // expect 1, c, text, 2.5, 7, true, null
        System.out.println(join("-")); // expect
        System.out.println(join("-", (Object) new String[] {"a"}.length)); // expect 1
        System.out.println(join("/", (Object[]) new String[] {"a", "b"})); // expect a/b
        System.out.println(which(1)); // expect one
        System.out.println(which(1, 2)); // expect many 2
        System.out.println(which()); // expect many 0
    }
}
