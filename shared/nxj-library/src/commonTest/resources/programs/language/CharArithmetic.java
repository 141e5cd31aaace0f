public class CharArithmetic {
    public static void main(String[] arguments) {
        char letter = 'A';
        System.out.println(letter); // prints: A
        letter++;
        System.out.println(letter); // prints: B
        letter += 2;
        System.out.println(letter - 'A'); // prints: 3
        System.out.println((int) (char) (letter + 256)); // prints: 324
        System.out.println('0' + 7); // prints: 55
        System.out.println(letter == 'D' ? 1 : 0); // prints: 1
        System.out.println('\n' + 0); // prints: 10
        System.out.println('\u00e4' + 0); // prints: 228
    }
}
