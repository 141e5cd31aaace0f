public class Arithmetic {
    public static void main(String[] arguments) {
        int a = 17;
        int b = -5;
        System.out.println(a + b); // prints: 12
        System.out.println(a - b); // prints: 22
        System.out.println(a * -b); // prints: 85
        System.out.println(-(a / b)); // prints: 3
        System.out.println(a % b); // prints: 2
        System.out.println(-(-a % b)); // prints: 2
        a += 3;
        a -= 1;
        a *= 2;
        a /= 3;
        a %= 7;
        System.out.println(a++); // prints: 5
        System.out.println(++a); // prints: 7
        System.out.println(--a - a--); // prints: 0
        System.out.println(Integer.MAX_VALUE + 1 == Integer.MIN_VALUE ? 1 : 0); // prints: 1
    }
}
