public class StringMethods {
    public static void main(String[] arguments) {
        String text = "Hello, World";
        System.out.println(text.length() + " " + text.charAt(4) + " " + text.isEmpty()); // prints: 12 o false
        System.out.println(text.indexOf('o') + " " + text.indexOf('o', 5) + " " + text.indexOf("World") + " " + text.indexOf("x")); // prints: 4 8 7 -1
        System.out.println(text.lastIndexOf('o') + " " + text.lastIndexOf("l", 5) + " " + text.lastIndexOf("Hello")); // prints: 8 3 0
        System.out.println(text.substring(7) + "," + text.substring(0, 5) + "," + text.substring(12) + ","); // prints: World,Hello,,
        System.out.println(text.startsWith("Hell") + " " + text.startsWith("World", 7) + " " + text.endsWith("ld")); // prints: true true true
        System.out.println(text.toUpperCase() + text.toLowerCase()); // prints: HELLO, WORLDhello, world
        System.out.println(text.replace('l', 'L')); // prints: HeLLo, WorLd
        System.out.println("[" + "  a b ".trim() + "]"); // prints: [a b]
        System.out.println(text.concat("!")); // prints: Hello, World!
        System.out.println("apple".compareTo("apricot") + " " + "a".compareTo("abc") + " " + "b".compareTo("a")); // prints: -2 -2 1
        System.out.println("ABC".equalsIgnoreCase("abc") + " " + "ABC".equals("abc")); // prints: true false
        System.out.println(text.hashCode() + " " + "".hashCode()); // prints: -505841268 0
        System.out.println(String.valueOf(3) + String.valueOf(2.5) + String.valueOf(true) + String.valueOf('c') + String.valueOf(7L)); // prints: 32.5truec7
        System.out.println(new String(new char[] {'a', 'b', 'c'}, 1, 2)); // prints: bc
        System.out.println(new String("bytes".getBytes()).equals("bytes")); // prints: true
        System.out.println(text.subSequence(2, 4)); // prints: ll
        System.out.println("a".equals(null)); // prints: false
        try {
            System.out.println(text.charAt(12));
        } catch (IndexOutOfBoundsException wrong) {
            System.out.println("outside"); // prints: outside
        }
        try {
            System.out.println(text.substring(5, 3));
        } catch (IndexOutOfBoundsException wrong) {
            System.out.println("backward"); // prints: backward
        }
    }
}
