public class CharArithmetic {
    public static void main(String[] arguments) {
        char letter = 'A';
        System.out.println(letter); // expect A
        letter++;
        System.out.println(letter); // expect B
        letter += 2;
        System.out.println(letter - 'A'); // expect 3
        System.out.println((int) (char) (letter + 256)); // expect 324
        System.out.println('0' + 7); // expect 55
        System.out.println(letter == 'D' ? 1 : 0); // expect 1
        System.out.println('\n' + 0); // expect 10
        System.out.println('\u00e4' + 0); // expect 228
    }
}
