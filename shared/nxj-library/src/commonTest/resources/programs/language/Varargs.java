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
        System.out.println(sum()); // prints: 0
        System.out.println(sum(4)); // prints: 4
        System.out.println(sum(1, 2, 3)); // prints: 6
        System.out.println(sum(new int[] {5, 6})); // prints: 11
        System.out.println(join(", ", 1, 'c', "text", 2.5, 7L, true, null)); // prints: 1, c, text, 2.5, 7, true, null
        System.out.println(join("-")); // prints:
        System.out.println(join("-", (Object) new String[] {"a"}.length)); // prints: 1
        System.out.println(join("/", (Object[]) new String[] {"a", "b"})); // prints: a/b
        System.out.println(which(1)); // prints: one
        System.out.println(which(1, 2)); // prints: many 2
        System.out.println(which()); // prints: many 0
    }
}
